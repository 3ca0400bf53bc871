// With a hundred thousand weights over thirty decades, frequencies equal pmf() exactly.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "raytracing/sampling/discrete.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr std::size_t kCount = 100000;
constexpr int kSteps = 1 << 24;  // number of uniform random numbers

// Makes log-uniform weights; every tenth is 0.
std::vector<float> unequal_weights() {
  TestRandom random(1);
  std::vector<float> weights(kCount);
  for (std::size_t i = 0; i < kCount; ++i)
    if (i % 10 != 3) weights[i] = std::pow(10.0f, random.between(-15, 15));
  return weights;
}

// Makes similar weights, each of about 168 steps.
std::vector<float> similar_weights() {
  TestRandom random(2);
  std::vector<float> weights(kCount);
  for (float& weight : weights) weight = random.between(0.5f, 1.5f);
  return weights;
}

// Makes many tiny weights followed by one with nearly all the probability.
std::vector<float> one_among_tiny_weights() {
  std::vector<float> weights(kCount, 1e-9f);
  weights[kCount - 2] = 1;
  return weights;
}

const std::vector<std::vector<float>>& all_weights() {
  static const std::vector<std::vector<float>> all = {unequal_weights(), similar_weights(),
                                                      one_among_tiny_weights()};
  return all;
}

// The frequencies over all uniform random numbers equal pmf(), so that dividing by it is unbiased.
TEST(DiscreteDistributionOfMany, FrequenciesEqualThePmfExactly) {
  for (const std::vector<float>& weights : all_weights()) {
    const DiscreteDistribution choose(weights);
    std::vector<int> counts(kCount);
    for (int k = 0; k < kSteps; ++k)
      ++counts[choose.sample(static_cast<float>(k) * 0x1p-24f).index];
    for (std::uint32_t i = 0; i < kCount; ++i) {
      ASSERT_EQ(static_cast<float>(counts[i]) * 0x1p-24f, choose.pmf(i)) << i;
      ASSERT_EQ(choose.pmf(i) > 0, weights[i] > 0) << i;
    }
  }
}

// The tolerance covers the own step of each item, two roundings to steps, and the fraction that the
// own steps take from all items: a hundred thousand of sixteen million.
TEST(DiscreteDistributionOfMany, ProbabilitiesAreTheShares) {
  for (const std::vector<float>& weights : all_weights()) {
    const DiscreteDistribution choose(weights);
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    double sum = 0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const double share = weights[i] / total;
      sum += choose.pmf(i);
      ASSERT_NEAR(choose.pmf(i), share, 2 * 0x1p-24 + share * kCount * 0x1p-24) << i;
    }
    EXPECT_EQ(sum, 1);
  }
}

TEST(DiscreteDistributionOfMany, RandomChoicesFollowTheProbabilities) {
  const double level = sidak_level(kFamilyLevel, static_cast<double>(all_weights().size()));
  for (const std::vector<float>& weights : all_weights()) {
    TestRandom random(3);
    const DiscreteDistribution choose(weights);
    std::vector<double> counts(kCount), expected(kCount);
    for (std::uint32_t i = 0; i < kCount; ++i) expected[i] = choose.pmf(i);
    for (int i = 0; i < 1000000; ++i) ++counts[choose.sample(random.unit()).index];
    EXPECT_GT(chi_square_test(counts, expected).p_value, level);
  }
}

}  // namespace
}  // namespace raytracing
