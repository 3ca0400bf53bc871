#include "raytracing/sampling/discrete.h"

#include <gtest/gtest.h>

#include <numeric>

#include "raytracing/math/numeric.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

const std::vector<std::vector<float>> kWeights = {
    {1},
    {2.5f, 2.5f},
    {0, 1, 0},
    {0, 0, 3, 1, 0, 2, 0, 0},
    {1, 2, 3, 4, 5, 6, 7},
    {1e-30f, 3e-30f, 2e-30f},
    {1e30f, 2e30f, 1e30f},
    {1, 1e-9f, 1, 1e-9f},
    {0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0},
};

TEST(DiscreteDistribution, ProbabilitiesAreTheSharesAndSumToOne) {
  for (const std::vector<float>& weights : kWeights) {
    const DiscreteDistribution choose(weights);
    ASSERT_EQ(choose.size(), weights.size());
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    double sum = 0;
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
      EXPECT_NEAR(choose.pmf(i), weights[i] / total, 3 * 0x1p-24);
      EXPECT_EQ(choose.pmf(i) > 0, weights[i] > 0);
      sum += choose.pmf(i);
    }
    EXPECT_EQ(sum, 1);
  }
}

TEST(DiscreteDistribution, NeverChoosesWeightZero) {
  TestRandom random(1);
  for (const std::vector<float>& weights : kWeights) {
    const DiscreteDistribution choose(weights);
    std::vector<float> us = {0.0f, 0x1p-24f, 0.5f, 1 - 0x1p-23f, kOneMinus};
    for (int i = 0; i < 1000; ++i) us.push_back(random.unit());
    // Each cumulative sum is tested with its neighbours.
    for (double sum = 0, total = std::accumulate(weights.begin(), weights.end(), 0.0);
         float weight : weights) {
      sum += weight;
      const auto border = static_cast<float>(sum / total);
      for (float u : {std::nextafter(border, 0.0f), border, std::nextafter(border, 1.0f)})
        us.push_back(std::min(u, kOneMinus));
    }
    for (float u : us) {
      const DiscreteDistribution::Choice choice = choose.sample(u);
      ASSERT_LT(choice.index, weights.size());
      EXPECT_GT(weights[choice.index], 0) << u;
      EXPECT_EQ(choice.pmf, choose.pmf(choice.index));
      EXPECT_TRUE(choice.u >= 0 && choice.u <= kOneMinus) << u;
    }
  }
}

// Choices follow the weights, and the remapped random number is uniform in each.
TEST(DiscreteDistribution, ChoicesFollowWeightsAndTheRestIsUniform) {
  const std::size_t cells = 10;
  for (const std::vector<float>& weights : kWeights) {
    TestRandom random(2);
    const DiscreteDistribution choose(weights);
    std::vector<double> counts(weights.size() * cells), expected;
    for (float weight : weights) expected.insert(expected.end(), cells, weight);
    for (int i = 0; i < 100000; ++i) {
      const DiscreteDistribution::Choice choice = choose.sample(random.unit());
      ++counts[choice.index * cells + cell_of(choice.u, cells)];
    }
    EXPECT_GT(chi_square_test(counts, expected).p_value,
              sidak_level(kFamilyLevel, static_cast<double>(kWeights.size())));
  }
}

// Of the regular numbers k/2^16, the fraction pmf(i) chooses item i.
TEST(DiscreteDistribution, SharesOfRegularNumbersAreThePmf) {
  for (const std::vector<float>& weights : kWeights) {
    const DiscreteDistribution choose(weights);
    std::vector<double> share(weights.size());
    for (int k = 0; k < 1 << 16; ++k)
      share[choose.sample((static_cast<float>(k) + 0.5f) * 0x1p-16f).index] += 0x1p-16;
    for (std::uint32_t i = 0; i < weights.size(); ++i)
      EXPECT_NEAR(share[i], choose.pmf(i), 0x1.01p-16) << i;
  }
}

}  // namespace
}  // namespace raytracing
