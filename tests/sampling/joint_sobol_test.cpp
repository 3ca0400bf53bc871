// The four numbers of pairs 0 and 1 form one 4D Owen-scrambled Sobol' sequence.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "raytracing/sampling/owen_sobol.h"
#include "raytracing/sampling/sampler.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

// Computes a coordinate by its definition: point i is the sum modulo 2 of the direction numbers
// m_k / 2^k of the bits set in i. The recurrences are those of Bratley & Fox 1988.
struct Definition {
  std::array<std::uint64_t, 33> m{};

  std::uint32_t at(std::uint32_t index) const {
    std::uint32_t x = 0;
    for (int k = 1; k <= 32; ++k)
      if (index >> (k - 1) & 1)
        x ^= static_cast<std::uint32_t>(m[static_cast<std::size_t>(k)] << (32 - k));
    return x;
  }
};

// This is the recurrence of the polynomial x^2 + x + 1.
Definition third() {
  Definition d;
  d.m[1] = 1;
  d.m[2] = 3;
  for (std::size_t k = 3; k <= 32; ++k) d.m[k] = 2 * d.m[k - 1] ^ 4 * d.m[k - 2] ^ d.m[k - 2];
  return d;
}

// This is the recurrence of the polynomial x^3 + x + 1.
Definition fourth() {
  Definition d;
  d.m[1] = 1;
  d.m[2] = 3;
  d.m[3] = 1;
  for (std::size_t k = 4; k <= 32; ++k) d.m[k] = 4 * d.m[k - 2] ^ 8 * d.m[k - 3] ^ d.m[k - 3];
  return d;
}

TEST(JointSobol, DirectionNumbersAreThePublishedOnes) {
  // The first direction numbers were computed from the recurrences by hand.
  const std::array<std::uint64_t, 6> in_third{1, 3, 3, 9, 29, 23}, in_fourth{1, 3, 1, 5, 31, 29};
  const Definition c = third(), d = fourth();
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(c.m[k + 1], in_third[k]) << k;
    EXPECT_EQ(d.m[k + 1], in_fourth[k]) << k;
  }
}

TEST(JointSobol, TablesAgreeWithTheDefinition) {
  const Definition c = third(), d = fourth();
  const auto check = [&](std::uint32_t i) {
    ASSERT_EQ(reverse_bits(kSobol3.reversed(i)), c.at(i)) << i;
    ASSERT_EQ(reverse_bits(kSobol4.reversed(i)), d.at(i)) << i;
  };
  for (std::uint32_t i = 0; i < 70000; ++i) check(i);
  for (int bit = 0; bit < 32; ++bit) check(1u << bit);
  TestRandom random(1);
  for (int i = 0; i < 100000; ++i) check(static_cast<std::uint32_t>(random.bits() >> 32));
}

using Numbers = std::array<float, 4>;

std::vector<Numbers> block(std::uint64_t seed, std::uint32_t x, std::uint64_t first, int k) {
  std::vector<Numbers> points;
  for (std::uint64_t s = first; s < first + (std::uint64_t{1} << k); ++s) {
    PathSampler sampler(SamplerKind::sobol, seed, x, 5 * x + 2, s);
    const Vec2 a = sampler.pair(0), b = sampler.pair(1);
    points.push_back({a.x, a.y, b.x, b.y});
  }
  return points;
}

// Divides axis i into 2^bits[i] slices; every box must contain the same number of points.
void expect_even(const std::vector<Numbers>& points, const std::array<int, 4>& bits) {
  std::size_t boxes = 1;
  for (int b : bits) boxes <<= b;
  ASSERT_EQ(points.size() % boxes, 0u);
  std::vector<std::size_t> counts(boxes);
  for (const Numbers& p : points) {
    std::size_t box = 0;
    for (std::size_t i = 0; i < 4; ++i)
      box = (box << bits[i]) | static_cast<std::size_t>(std::ldexp(p[i], bits[i]));
    ++counts[box];
  }
  for (std::size_t count : counts)
    ASSERT_EQ(count, points.size() / boxes)
        << bits[0] << " " << bits[1] << " " << bits[2] << " " << bits[3];
}

// A coordinate of degree e adds e - 1 to the t of its projections (Niederreiter 1992, theorem
// 4.49). The 2^k points of a block are thus equidistributed in all boxes of volume 2^(t-k).
int quality(const std::array<int, 4>& bits) {
  constexpr std::array excess{0, 0, 1, 2};
  int t = 0;
  for (std::size_t i = 0; i < 4; ++i) t += bits[i] > 0 ? excess[i] : 0;
  return t;
}

void expect_promised_nets(const std::vector<Numbers>& points, int k) {
  for (int a = 0; a <= k; ++a)
    for (int b = 0; a + b <= k; ++b)
      for (int c = 0; a + b + c <= k; ++c)
        for (int d = 0; a + b + c + d <= k; ++d) {
          const std::array bits{a, b, c, d};
          const bool one_axis = std::max({a, b, c, d}) == a + b + c + d;
          if (a + b + c + d > k - (one_axis ? 0 : quality(bits))) continue;
          expect_even(points, bits);
          if (testing::Test::HasFatalFailure()) return;
        }
}

// It follows that each number alone is stratified in 2^k strata, that pair 0 is a (0, k, 2)-net,
// pair 1 a (3, k, 2)-net, and all four numbers a (3, k, 4)-net.
TEST(JointSobol, BlocksAreTheNetsThatTheSequencePromises) {
  for (std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}})
    for (std::uint32_t x : {0u, 1u, 1023u}) {
      for (int k = 0; k <= 8; ++k) expect_promised_nets(block(seed, x, 0, k), k);
      expect_promised_nets(block(seed, x, 3 << 8, 8), 8);
      expect_promised_nets(block(seed, x, (std::uint64_t{5} << 32) + 64, 6), 6);
    }
  expect_promised_nets(block(7, 7, 0, 12), 12);
}

// The four coordinates and different pixels are scrambled independently: over the pixels, the four
// numbers of the first sample are jointly uniform.
TEST(JointSobol, TheFourScramblingsAreIndependent) {
  for (std::uint64_t sample : {0u, 1u, 37u}) {
    std::vector<double> counts(256);
    for (std::uint32_t x = 0; x < 1 << 14; ++x) {
      std::size_t cell = 0;
      const Numbers numbers = block(3, x, sample, 0).front();
      for (float v : numbers) cell = 4 * cell + cell_of(v, 4);
      ++counts[cell];
    }
    EXPECT_GT(chi_square_uniform(counts).p_value, sidak_level(kFamilyLevel, 3)) << sample;
  }
}

}  // namespace
}  // namespace raytracing
