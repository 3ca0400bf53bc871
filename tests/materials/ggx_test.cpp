// The parts of the GGX conductor that bsdf.h does not show.
#include "raytracing/materials/ggx.h"

#include <gtest/gtest.h>

#include "ggx_reference.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr float kAlphas[] = {0.001f, 0.01f, 0.05f, 0.1f, 0.3f, 0.6f, 1.0f};
constexpr float kCosines[] = {1.0f, 0.8f, 0.5f, 0.2f, 0.05f, 0.01f};
constexpr std::size_t kCells = 12;

Vec3 at_cosine(float cosine, float phi = 0.7f) {
  const float sine = std::sqrt((1 - cosine) * (1 + cosine));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

// G1(wo) D(h) max(0, wo.h) per unit of the square of HalfVector.
double visible(float alpha, const DVec3& wo, double s, double turn) {
  const HalfVector at{s, turn};
  const DVec3 h = at.direction(alpha);
  const double g1 = 1 / (1 + reference_lambda(alpha, wo));
  return g1 * double{ggx::distribution(alpha, Vec3(h))} * std::max(0.0, dot(wo, h)) *
         at.solid_angle(alpha);
}

// The microfacets project to the whole surface: integral of D cos = 1 (Walter et al. 2007, eq. 4).
TEST(Ggx, NormalsProjectToOne) {
  for (float alpha : kAlphas) {
    const auto projected = [&](double s, double turn) {
      const HalfVector at{s, turn};
      const DVec3 h = at.direction(alpha);
      return double{ggx::distribution(alpha, Vec3(h))} * h.z * at.solid_angle(alpha);
    };
    EXPECT_NEAR(integrate2(projected, 0, 1, 0, 1, 8), 1, 1e-4) << alpha;
  }
}

TEST(Ggx, DistributionAndStretchedLengthAreThoseOfTheReference) {
  TestRandom random(1);
  for (float alpha : kAlphas)
    for (int i = 0; i < 2000; ++i) {
      const Vec3 h(HalfVector{random.between(0.01f, 1), random.unit()}.direction(alpha));
      const double d = reference_distribution(alpha, DVec3(h));
      EXPECT_NEAR(ggx::distribution(alpha, h) / d, 1, 1e-5) << alpha;
      const Vec3 w = at_cosine(random.between(1e-4f, 1));
      const double stretched = w.z * (1 + 2 * reference_lambda(alpha, DVec3(w)));
      EXPECT_NEAR(ggx::stretched(alpha, w) / stretched, 1, 1e-5) << alpha;
    }
}

// The microfacets seen from wo fill what wo sees of the surface (Heitz 2014, eq. 14).
TEST(Ggx, VisibleNormalsProjectToTheCosineOfTheViewer) {
  for (float alpha : kAlphas)
    for (float cosine : kCosines) {
      const DVec3 wo(at_cosine(cosine));
      const double sum = integrate2(
          [&](double s, double turn) { return visible(alpha, wo, s, turn); }, 0, 1, 0, 1, 60);
      EXPECT_NEAR(sum / wo.z, 1, 1e-4) << alpha << " " << cosine;
    }
}

TEST(Ggx, SampledNormalsAreTheVisibleOnes) {
  const double level = sidak_level(kFamilyLevel, std::size(kAlphas) * std::size(kCosines));
  for (float alpha : kAlphas)
    for (float cosine : kCosines) {
      const Vec3 wo = at_cosine(cosine);
      std::vector<double> counts(kCells * kCells), expected;
      for (std::size_t i = 0; i < kCells * kCells; ++i) {
        const double s = double(i / kCells) / kCells, turn = double(i % kCells) / kCells;
        expected.push_back(
            integrate2([&](double x, double y) { return visible(alpha, DVec3(wo), x, y); }, s,
                       s + 1.0 / kCells, turn, turn + 1.0 / kCells, 5));
      }
      TestRandom random(2);
      for (int i = 0; i < 20000; ++i) {
        const Vec3 h = ggx::sample_visible_normal(alpha, wo, random.unit2());
        ASSERT_NEAR(length(h), 1, 3e-7);
        const HalfVector at = HalfVector::of(alpha, DVec3(h));
        ++counts[kCells * cell_of(at.s, kCells) + cell_of(at.turn, kCells)];
      }
      EXPECT_GT(chi_square_test(counts, expected).p_value, level) << alpha << " " << cosine;
    }
}

TEST(Ggx, ReflectanceIsConstantOrSchlicks) {
  const GgxConductor constant{Rgb(0.2f, 0.5f, 0.9f), 0.1f, Fresnel::none};
  EXPECT_EQ(ggx::reflectance(constant, 0.1f), Rgb(0.2f, 0.5f, 0.9f));
  const GgxConductor schlick{Rgb(0.2f, 0.5f, 0.9f), 0.1f, Fresnel::schlick};
  EXPECT_EQ(ggx::reflectance(schlick, 1), Rgb(0.2f, 0.5f, 0.9f));
  EXPECT_EQ(ggx::reflectance(schlick, 1 + 1e-6f), Rgb(0.2f, 0.5f, 0.9f));
  EXPECT_EQ(ggx::reflectance(schlick, 0), Rgb(1.0f));
  EXPECT_NEAR(ggx::reflectance(schlick, 0.5f).x, 0.2 + 0.8 / 32, 1e-6);
  EXPECT_NEAR(ggx::reflectance(schlick, 0.2f).y, 0.5 + 0.5 * std::pow(0.8, 5), 1e-6);
}

}  // namespace
}  // namespace raytracing
