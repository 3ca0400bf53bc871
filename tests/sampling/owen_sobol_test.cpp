#include "raytracing/sampling/owen_sobol.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

#include "raytracing/sampling/sampler.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

// By definition (Bratley & Fox 1988) with the polynomial x + 1, m_k = 2 m_(k-1) xor m_(k-1), m_1 =
// 1, and the direction number of bit k - 1 of the index is m_k / 2^k.
std::uint32_t sobol2_by_definition(std::uint32_t index) {
  std::uint64_t m = 1;
  std::uint32_t x = 0;
  for (int k = 1; k <= 32; ++k) {
    if (index >> (k - 1) & 1) x ^= static_cast<std::uint32_t>(m << (32 - k));
    m ^= 2 * m;
  }
  return x;
}

TEST(OwenSobol, ReverseBits) {
  for (int k = 0; k < 32; ++k) EXPECT_EQ(reverse_bits(1u << k), 1u << (31 - k));
  EXPECT_EQ(reverse_bits(0x00000013u), 0xc8000000u);
}

TEST(OwenSobol, SecondDimensionIsTheOneOfTheDirectionNumbers) {
  for (std::uint32_t i = 0; i < 70000; ++i)
    ASSERT_EQ(reverse_bits(reversed_sobol2(i)), sobol2_by_definition(i)) << i;
  TestRandom random(1);
  for (int i = 0; i < 100000; ++i) {
    const auto index = static_cast<std::uint32_t>(random.bits() >> 32);
    ASSERT_EQ(reverse_bits(reversed_sobol2(index)), sobol2_by_definition(index)) << index;
  }
}

// Changing bit k changes bit k of the result and no lower bit. The low bits are thus mapped
// bijectively, which permutes the intervals of every dyadic partition.
TEST(OwenSobol, ScramblingIsNested) {
  TestRandom random(2);
  for (int i = 0; i < 100000; ++i) {
    const auto x = static_cast<std::uint32_t>(random.bits() >> 32);
    const auto seed = static_cast<std::uint32_t>(random.bits() >> 32);
    for (int k = 0; k < 32; ++k) {
      const std::uint32_t other = x ^ (1u << k);
      const std::uint32_t change = scramble_reversed(x, seed) ^ scramble_reversed(other, seed);
      ASSERT_EQ(std::countr_zero(change), k) << x << " " << seed;
    }
  }
}

// A random scrambling flips each bit with probability 1/2 for any lower bits. The hash comes close:
// averaged over seeds, each bit of the result is set in 49 to 51 %.
TEST(OwenSobol, ScramblingDependsOnTheSeedInEveryBit) {
  TestRandom random(3);
  for (std::uint32_t x : {0u, 1u, 0x80000000u, 0x12345678u, 0xffffffffu}) {
    std::array<int, 32> set{};
    const int n = 100000;
    for (int i = 0; i < n; ++i) {
      const std::uint32_t y = scramble_reversed(x, static_cast<std::uint32_t>(random.bits() >> 32));
      for (int k = 0; k < 32; ++k) set[k] += y >> k & 1;
    }
    for (int k = 0; k < 32; ++k) EXPECT_NEAR(set[k], n / 2, n / 100) << x << " bit " << k;
  }
}

// For the first 2^k samples of any pixel, seed and pair, each cell of every partition into 2^a
// columns and 2^(k-a) rows contains exactly one point.
void expect_net(std::uint64_t seed, std::uint32_t pixel, std::uint32_t pair, std::uint64_t first,
                int k) {
  std::vector<Vec2> points;
  for (std::uint64_t s = first; s < first + (1u << k); ++s)
    points.push_back(PathSampler(SamplerKind::sobol, seed, pixel, 3 * pixel + 1, s).pair(pair));
  for (int a = 0; a <= k; ++a) {
    std::set<std::pair<int, int>> cells;
    for (const Vec2& p : points)
      cells.emplace(static_cast<int>(std::ldexp(p.x, a)), static_cast<int>(std::ldexp(p.y, k - a)));
    ASSERT_EQ(cells.size(), points.size())
        << "seed " << seed << " pixel " << pixel << " pair " << pair << " k " << k << " a " << a;
  }
}

// Pair 1 has the third and fourth coordinate of the sequence of pair 0: see joint_sobol_test.cpp.
TEST(OwenSobol, SamplesOfEveryPairButOneAreNetsInBaseTwo) {
  for (std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}})
    for (std::uint32_t pixel : {0u, 1u, 1023u})
      for (std::uint32_t pair : {0u, 2u, 15u, 16u, 77u}) {
        for (int k = 0; k <= 8; ++k) expect_net(seed, pixel, pair, 0, k);
        expect_net(seed, pixel, pair, 3 << 8, 8);                         // a later block
        expect_net(seed, pixel, pair, (std::uint64_t{5} << 32) + 64, 6);  // past 2^32
      }
  expect_net(7, 7, 7, 0, 12);
}

}  // namespace
}  // namespace raytracing
