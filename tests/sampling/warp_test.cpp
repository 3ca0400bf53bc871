#include "raytracing/sampling/warp.h"

#include <gtest/gtest.h>

#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr int kSamples = 200000;
const double kLevel = sidak_level(kFamilyLevel, 4);  // the number of chi-square tests in this file

// Numbers at and next to the ends, the quarters and the middle of [0, 1).
constexpr float kExtremes[] = {0.0f, 0x1p-24f, 0.25f,           0.5f - 0x1p-25f,
                               0.5f, 0.75f,    0.5f + 0x1p-24f, kOneMinus};

double turn_of(double x, double y) { return std::atan2(y, x) / (2 * std::numbers::pi) + 0.5; }

// The cells are sectors of rings of equal area.
TEST(Warp, DiskIsUniform) {
  TestRandom random(1);
  std::vector<double> counts(16 * 16);
  for (int i = 0; i < kSamples; ++i) {
    const Vec2 d = square_to_disk(random.unit2());
    ++counts[16 * cell_of(dot(d, d), 16) + cell_of(turn_of(d.x, d.y), 16)];
  }
  EXPECT_GT(chi_square_uniform(counts).p_value, kLevel);
}

// The map is concentric: a square of radius r maps to a disk of radius r, and halves to halves.
TEST(Warp, DiskKeepsRingsAndQuadrants) {
  TestRandom random(2);
  for (int i = 0; i < 10000; ++i) {
    const Vec2 u = random.unit2();
    const Vec2 d = square_to_disk(u);
    const float a = 2 * u.x - 1, b = 2 * u.y - 1;
    EXPECT_NEAR(std::sqrt(dot(d, d)), std::max(std::abs(a), std::abs(b)), 2e-7);
    EXPECT_GE(d.x * a, -1e-7);
    EXPECT_GE(d.y * b, -1e-7);
  }
}

TEST(Warp, CosineHemisphereHasItsDensity) {
  TestRandom random(3);
  const std::size_t nz = 16, nphi = 16;
  std::vector<double> counts(nz * nphi), expected;
  for (std::size_t i = 0; i < nz; ++i) {
    const auto density = [](double z) { return double{cosine_hemisphere_pdf_w(float(z))}; };
    const double mass =
        2 * std::numbers::pi * integrate(density, double(i) / nz, double(i + 1) / nz) / nphi;
    expected.insert(expected.end(), nphi, mass);
  }
  for (int i = 0; i < kSamples; ++i) {
    const Vec3 w = square_to_cosine_hemisphere(random.unit2());
    ++counts[nphi * cell_of(w.z, nz) + cell_of(turn_of(w.x, w.y), nphi)];
  }
  EXPECT_GT(chi_square_test(counts, expected).p_value, kLevel);
}

TEST(Warp, CosineHemisphereDensityIntegratesToOne) {
  const auto density = [](double z) { return double{cosine_hemisphere_pdf_w(float(z))}; };
  EXPECT_NEAR(2 * std::numbers::pi * integrate(density, 0, 1, 4), 1, 1e-6);
  EXPECT_EQ(cosine_hemisphere_pdf_w(-0.5f), 0);
}

// The cells are n^2 congruent triangles: cells of the weights, split by their diagonals.
TEST(Warp, TriangleIsUniform) {
  TestRandom random(4);
  const std::size_t n = 8;
  std::vector<double> counts(2 * n * n), expected(2 * n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t upper : {0u, 1u})
        if (i + j + upper < n) expected[2 * (n * i + j) + upper] = 1;
  for (int k = 0; k < kSamples; ++k) {
    const Vec2 w = square_to_triangle(random.unit2());
    const std::size_t i = cell_of(w.x, n), j = cell_of(w.y, n);
    const bool upper = (w.x + w.y) * n >= double(i + j + 1);
    ++counts[2 * (n * i + j) + std::size_t{upper && i + j + 1 < n}];
  }
  EXPECT_GT(chi_square_test(counts, expected).p_value, kLevel);
}

TEST(Warp, ExtremesStayInside) {
  for (float x : kExtremes)
    for (float y : kExtremes) {
      const Vec2 d = square_to_disk({x, y});
      EXPECT_LE(dot(d, d), 1 + 3e-7f) << x << " " << y;
      const Vec3 w = square_to_cosine_hemisphere({x, y});
      EXPECT_NEAR(length(w), 1, 3e-7) << x << " " << y;
      EXPECT_GE(w.z, 0);
      const Vec2 b = square_to_triangle({x, y});
      EXPECT_TRUE(b.x >= 0 && b.y >= 0 && b.x + b.y <= 1) << x << " " << y;
    }
  EXPECT_EQ(square_to_disk({0.5f, 0.5f}), Vec2(0, 0));
  EXPECT_EQ(square_to_cosine_hemisphere({0.5f, 0.5f}), Vec3(0, 0, 1));
}

}  // namespace
}  // namespace raytracing
