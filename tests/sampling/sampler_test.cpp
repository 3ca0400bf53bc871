#include "raytracing/sampling/sampler.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "raytracing/math/numeric.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr SamplerKind kBoth[] = {SamplerKind::sobol, SamplerKind::independent};

// Families of tests share the level kFamilyLevel; none of them has more members than this.
const double kLevel = sidak_level(kFamilyLevel, 60);

TEST(PathSampler, KindsHaveNames) {
  for (SamplerKind kind : kBoth) EXPECT_EQ(sampler_kind(to_string(kind)), kind);
  EXPECT_EQ(to_string(SamplerKind::sobol), "sobol");
  EXPECT_EQ(to_string(SamplerKind::independent), "independent");
  EXPECT_EQ(sampler_kind("halton"), std::nullopt);
}

TEST(PathSampler, OrderOfCallsDoesNotMatter) {
  for (SamplerKind kind : kBoth) {
    const auto fresh = [&](std::uint32_t i) { return PathSampler(kind, 9, 4, 5, 77).pair(i); };
    PathSampler sampler(kind, 9, 4, 5, 77);
    for (std::uint32_t i : {40u, 3u, 15u, 16u, 0u, 3u, 4294967295u, 31u, 32u, 3u, 4294967280u})
      EXPECT_EQ(sampler.pair(i), fresh(i)) << i;
    EXPECT_EQ(sampler.extra(3, 1), PathSampler(kind, 9, 4, 5, 77).extra(3, 1));
  }
}

// PixelSampler equals the constructor whether sample, pixel, epoch or replicate changes.
TEST(PixelSampler, GivesWhatTheConstructorGives) {
  const std::uint64_t epoch = std::uint64_t{1} << 32;
  for (SamplerKind kind : kBoth) {
    PixelSampler pixels(kind, 9);
    for (const auto& [x, y, sample, replicate] : {std::array<std::uint64_t, 4>{0, 0, 0, 0},
                                                  {0, 0, 1, 0},
                                                  {4, 0, 1, 0},
                                                  {4, 5, 1, 0},
                                                  {5, 4, 1, 0},
                                                  {5, 4, 1 + epoch, 0},
                                                  {5, 4, 1, 0},
                                                  {5, 4, 1, 1},
                                                  {5, 4, 2, 1}}) {
      const auto px = static_cast<std::uint32_t>(x), py = static_cast<std::uint32_t>(y);
      PathSampler kept = pixels.path(px, py, sample, replicate);
      PathSampler made(kind, 9, px, py, sample, replicate);
      for (std::uint32_t i : {0u, 1u, 15u, 16u, 40u, 3u}) {
        EXPECT_EQ(kept.pair(i), made.pair(i)) << x << " " << y << " " << sample << " " << i;
        EXPECT_EQ(kept.extra(i, 2), made.extra(i, 2));
        EXPECT_EQ(kept.coin_of_pixel(i), made.coin_of_pixel(i));
      }
    }
  }
}

TEST(PathSampler, NumbersLieBelowOne) {
  EXPECT_EQ(unit_float(0), 0.0f);
  EXPECT_EQ(unit_float(0xffffffffu), kOneMinus);
  for (SamplerKind kind : kBoth)
    for (std::uint64_t s = 0; s < 20000; ++s) {
      PathSampler sampler(kind, 1, 2, 3, s);
      for (std::uint32_t i = 0; i < 32; ++i)
        for (float v : {sampler.pair(i).x, sampler.pair(i).y, sampler.extra(i, i)})
          ASSERT_TRUE(v >= 0 && v <= kOneMinus) << v;
    }
}

// All arguments change every number, and so do bits 32 and above of the sample index.
TEST(PathSampler, EveryArgumentCounts) {
  for (SamplerKind kind : kBoth) {
    PathSampler base(kind, 1, 2, 3, 4);
    const std::uint64_t high = std::uint64_t{1} << 32;
    for (PathSampler other :
         {PathSampler(kind, 2, 2, 3, 4), PathSampler(kind, 1 + high, 2, 3, 4),
          PathSampler(kind, 1, 3, 3, 4), PathSampler(kind, 1, 3, 2, 4),
          PathSampler(kind, 1, 2, 4, 4), PathSampler(kind, 1, 2, 3, 5),
          PathSampler(kind, 1, 2, 3, 4 + high), PathSampler(kind, 1, 2, 3, 4 + 2 * high),
          PathSampler(kind, 1, 2, 3, 4 + (high << 31))})
      for (std::uint32_t i : {0u, 1u, 20u}) {
        EXPECT_NE(base.pair(i).x, other.pair(i).x);
        EXPECT_NE(base.pair(i).y, other.pair(i).y);
        for (std::uint32_t j : {0u, 1u, 2u}) EXPECT_NE(base.extra(i, j), other.extra(i, j));
      }
    for (std::uint32_t i = 1; i < 20; ++i) {
      EXPECT_NE(base.pair(i), base.pair(0));
      EXPECT_NE(base.extra(i, 0), base.extra(0, 0));
      EXPECT_NE(base.extra(0, i), base.extra(0, 0));
    }
  }
}

using Numbers = std::function<std::array<float, 4>(std::uint32_t)>;

// Returns the p-value of "the four numbers are independent and uniform" from 4^4 cells and n
// points.
double joint_p_value(const Numbers& numbers, std::uint32_t n) {
  std::vector<double> counts(256);
  for (std::uint32_t i = 0; i < n; ++i) {
    std::size_t cell = 0;
    for (float v : numbers(i)) cell = 4 * cell + cell_of(v, 4);
    ++counts[cell];
  }
  return chi_square_uniform(counts).p_value;
}

std::array<float, 4> join(const Vec2& a, const Vec2& b) { return {a.x, a.y, b.x, b.y}; }

// Two pairs of a sample are tested over the pixels of an image and over the samples of a pixel.
// Nets fill the cells more evenly than random points; the test rejects only uneven filling.
TEST(PathSampler, PairsAreIndependentOfEachOther) {
  const std::uint32_t n = 1 << 14;
  for (SamplerKind kind : kBoth)
    for (auto [a, b] : {std::pair{0u, 1u}, {0u, 2u}, {1u, 16u}, {15u, 16u}, {3u, 1000u}}) {
      const auto over_pixels = [&](std::uint32_t i) {
        PathSampler sampler(kind, 5, i % 128, i / 128, 6);
        return join(sampler.pair(a), sampler.pair(b));
      };
      EXPECT_GT(joint_p_value(over_pixels, n), kLevel) << to_string(kind) << a << " " << b;
      const auto over_samples = [&](std::uint32_t i) {
        PathSampler sampler(kind, 5, 9, 9, i);
        return join(sampler.pair(a), sampler.pair(b));
      };
      EXPECT_GT(joint_p_value(over_samples, n), kLevel) << to_string(kind) << a << " " << b;
    }
}

// The same pair is independent in neighbouring pixels, seeds and blocks of samples.
TEST(PathSampler, PixelsAndSeedsAreIndependentOfEachOther) {
  const std::uint32_t n = 1 << 14;
  for (SamplerKind kind : kBoth)
    for (std::uint32_t d : {0u, 1u, 17u}) {
      const auto test = [&](const char* name, auto&& first, auto&& second) {
        const auto numbers = [&](std::uint32_t i) {
          return join(PathSampler(first(i)).pair(d), PathSampler(second(i)).pair(d));
        };
        EXPECT_GT(joint_p_value(numbers, n), kLevel) << to_string(kind) << " " << name << " " << d;
      };
      const auto at = [&](std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint64_t s) {
        return PathSampler(kind, seed, x, y, s);
      };
      test(
          "x", [&](auto i) { return at(1, 2 * (i % 64), i / 64, 0); },
          [&](auto i) { return at(1, 2 * (i % 64) + 1, i / 64, 0); });
      test(
          "y", [&](auto i) { return at(1, i % 256, 2 * (i / 256), 3); },
          [&](auto i) { return at(1, i % 256, 2 * (i / 256) + 1, 3); });
      test(
          "seed", [&](auto i) { return at(2 * i, 4, 4, 1); },
          [&](auto i) { return at(2 * i + 1, 4, 4, 1); });
      test(
          "samples", [&](auto i) { return at(1, 3, 3, i); },
          [&](auto i) { return at(1, 4, 3, i); });
      test(
          "past 2^32", [&](auto i) { return at(1, 3, 3, i); },
          [&](auto i) { return at(1, 3, 3, i + (std::uint64_t{1} << 32)); });
    }
}

// Extra numbers are independent of each other, over samples and pixels, and of their pair.
TEST(PathSampler, ExtraNumbersAreIndependent) {
  const std::uint32_t n = 1 << 14;
  for (SamplerKind kind : kBoth)
    for (std::uint32_t d : {0u, 1u, 17u}) {
      const auto of = [&](const PathSampler& s) {
        return std::array{s.extra(d, 0), s.extra(d, 1), s.extra(d, 2), s.extra(d + 1, 0)};
      };
      const auto with_pair = [&](PathSampler&& s) {
        return join(s.pair(d), {s.extra(d, 0), s.extra(d, 1)});
      };
      const auto sample = [&](std::uint32_t i) { return PathSampler(kind, 5, 9, 9, i); };
      const auto pixel = [&](std::uint32_t i) { return PathSampler(kind, 5, i % 128, i / 128, 0); };
      const Numbers all[] = {
          [&](auto i) { return of(sample(i)); }, [&](auto i) { return of(pixel(i)); },
          [&](auto i) { return with_pair(sample(i)); }, [&](auto i) { return with_pair(pixel(i)); },
          [&](auto i) {
            return join({sample(2 * i).extra(d, 0), sample(2 * i).extra(d, 1)},
                        {sample(2 * i + 1).extra(d, 0), pixel(i).extra(d, 0)});
          }};
      for (const Numbers& numbers : all)
        EXPECT_GT(joint_p_value(numbers, n), kLevel) << to_string(kind) << " " << d;
    }
}

}  // namespace
}  // namespace raytracing
