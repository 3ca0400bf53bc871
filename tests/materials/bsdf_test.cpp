#include <gtest/gtest.h>

#include "ggx_reference.h"
#include "raytracing/materials/material.h"
#include "raytracing/math/numeric.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr float kAlphas[] = {0.001f, 0.01f, 0.05f, 0.1f, 0.3f, 0.6f, 1.0f};
constexpr float kCosines[] = {1.0f, 0.8f, 0.5f, 0.2f, 0.05f, 0.01f};
constexpr float kExtremes[] = {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, 1 - 0x1p-23f, kOneMinus};
constexpr std::size_t kCells = 12;
constexpr std::size_t kMaterials = 1 + std::size(kAlphas);

// White materials: diffuse and GGX of every width.
std::vector<Material> materials(Fresnel fresnel = Fresnel::none, const Rgb& reflectance = Rgb(1)) {
  std::vector<Material> all = {Diffuse{reflectance}};
  for (float alpha : kAlphas) all.push_back(GgxConductor{reflectance, alpha, fresnel});
  return all;
}

// The width of the coordinates in which a material is tested: its own, or 1 for the diffuse.
float width(const Material& m) {
  const GgxConductor* ggx = std::get_if<GgxConductor>(&m);
  return ggx ? ggx->alpha : 1.0f;
}

std::string name(const Material& m, const Vec3& wo) {
  const bool diffuse = std::holds_alternative<Diffuse>(m);
  return (diffuse ? "diffuse" : "alpha " + std::to_string(width(m))) + " cos " +
         std::to_string(wo.z);
}

Vec3 at_cosine(float cosine, float phi = 0.7f) {
  const float sine = std::sqrt((1 - cosine) * (1 + cosine));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

// The integrand f(wi) per unit of the square of half vectors: d wi = 4 |wo.h| d h.
template <class F>
double over_half_vectors(double alpha, const DVec3& wo, const HalfVector& at, const F& f) {
  const DVec3 h = at.direction(alpha);
  const double wo_dot_h = dot(wo, h);
  if (wo_dot_h <= 0) return 0;
  const DVec3 wi = 2 * wo_dot_h * h - wo;
  return wi.z <= 0 ? 0.0 : double{f(Vec3(wi))} * 4 * wo_dot_h * at.solid_angle(alpha);
}

// The integral of f(wi) over the cells of half vectors. Cells cut by the horizon need many nodes.
template <class F>
std::vector<double> cell_integrals(const Material& m, const Vec3& wo, const F& f, int panels) {
  std::vector<double> result;
  for (std::size_t i = 0; i < kCells * kCells; ++i) {
    const double s = double(i / kCells) / kCells, turn = double(i % kCells) / kCells;
    result.push_back(integrate2(
        [&](double x, double y) {
          return over_half_vectors(width(m), DVec3(wo), {x, y}, f);
        },
        s, s + 1.0 / kCells, turn, turn + 1.0 / kCells, panels));
  }
  return result;
}

double sum_of(const std::vector<double>& numbers) {
  double sum = 0;
  for (double x : numbers) sum += x;
  return sum;
}

std::size_t cell_of_direction(const Material& m, const Vec3& wo, const Vec3& wi) {
  const HalfVector at = HalfVector::of(width(m), normalize(DVec3(wo) + DVec3(wi)));
  return kCells * cell_of(at.s, kCells) + cell_of(at.turn, kCells);
}

// Cells of half vectors, and one for the samples that end below the horizon. Counts follow the
// density; the last cell takes what the density leaves of 1.
TEST(Bsdf, SamplesFollowTheirDensity) {
  const double level = sidak_level(kFamilyLevel, kMaterials * std::size(kCosines));
  const int samples = 20000;
  for (const Material& m : materials())
    for (float cosine : kCosines) {
      const Vec3 wo = at_cosine(cosine);
      const auto density = [&](const Vec3& wi) { return bsdf_pdf_w(m, wo, wi); };
      std::vector<double> expected = cell_integrals(m, wo, density, 10);
      const double mass = sum_of(expected);
      EXPECT_LE(mass, 1 + 3e-4) << name(m, wo);
      expected.push_back(std::max(0.0, 1 - mass));
      std::vector<double> counts(expected.size());
      TestRandom random(1);
      for (int i = 0; i < samples; ++i) {
        const auto s = sample_bsdf(m, wo, random.unit2());
        ++counts[s ? cell_of_direction(m, wo, s->wi) : kCells * kCells];
      }
      const ChiSquare test = chi_square_test(counts, expected);
      EXPECT_GT(test.p_value, level) << name(m, wo);
      EXPECT_GE(test.degrees, 20) << name(m, wo);
    }
}

// What a sample says of itself is what the functions say of it. The half vector of two nearly
// opposite directions is rounded, so that the densities of narrow lobes agree less well there.
TEST(Bsdf, SamplesAgreeWithEvaluation) {
  for (Fresnel fresnel : {Fresnel::none, Fresnel::schlick})
    for (const Material& m : materials(fresnel, Rgb(0.2f, 0.5f, 1)))
      for (float cosine : kCosines) {
        const Vec3 wo = at_cosine(cosine);
        TestRandom random(2);
        for (int i = 0; i < 5000; ++i) {
          const auto s = sample_bsdf(m, wo, random.unit2());
          if (!s) continue;
          ASSERT_NEAR(length(s->wi), 1, 1e-6);
          const float pdf_w = bsdf_pdf_w(m, wo, s->wi);
          const double rounding = 1e-5 + 1e-6 / (width(m) * length(wo + s->wi));
          ASSERT_NEAR(pdf_w / s->pdf_w, 1, rounding) << name(m, wo) << " wi.z " << s->wi.z;
          const Rgb f = eval_cos(m, wo, s->wi);
          for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(s->weight[c], f[c] / pdf_w, 2e-5 + 1e-3 * rounding) << name(m, wo);
        }
      }
}

TEST(Bsdf, ReciprocalAndBlackBelowTheHorizon) {
  TestRandom random(3);
  for (const Material& m : materials(Fresnel::schlick, Rgb(0.2f, 0.5f, 1)))
    for (int i = 0; i < 5000; ++i) {
      const Vec3 a = at_cosine(random.between(0.01f, 1), random.between(0, 7));
      const Vec3 b = at_cosine(random.between(0.01f, 1), random.between(0, 7));
      const Rgb ab = eval_cos(m, a, b) / b.z, ba = eval_cos(m, b, a) / a.z;
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(ab[c], ba[c], 1e-5f * (ab[c] + 1e-20f)) << name(m, a);
      const Vec3 below(b.x, b.y, -b.z);
      ASSERT_EQ(eval_cos(m, a, below), Rgb(0.0f));
      ASSERT_EQ(bsdf_pdf_w(m, a, below), 0);
    }
}

TEST(Bsdf, GgxIsTheReference) {
  TestRandom random(4);
  for (float alpha : kAlphas)
    for (int i = 0; i < 5000; ++i) {
      const Vec3 wo = at_cosine(random.between(0.01f, 1), random.between(0, 7));
      const DVec3 h = HalfVector{random.between(0.01f, 1), random.unit()}.direction(alpha);
      const Vec3 wi(2 * dot(DVec3(wo), h) * h - DVec3(wo));
      if (wi.z < 1e-3f || dot(DVec3(wo), h) <= 0) continue;
      const double expected = reference_f(alpha, DVec3(wo), DVec3(wi)) * wi.z;
      const double rounding = 1e-5 + 1e-6 / (alpha * length(wo + wi));
      const Material m = GgxConductor{Rgb(0.25f), alpha, Fresnel::none};
      ASSERT_NEAR(eval_cos(m, wo, wi).x / (0.25 * expected), 1, rounding) << name(m, wo);
    }
}

// With reflectance 1 no more light leaves than arrives; a nearly smooth surface returns all.
// The mean weight of samples is the same albedo.
TEST(Bsdf, WhiteFurnace) {
  const double level = sidak_level(kFamilyLevel, kMaterials * std::size(kCosines));
  for (const Material& m : materials())
    for (float cosine : kCosines) {
      const Vec3 wo = at_cosine(cosine);
      const auto f = [&](const Vec3& wi) { return eval_cos(m, wo, wi).x; };
      const double albedo = sum_of(cell_integrals(m, wo, f, 6));
      EXPECT_LE(albedo, 1 + 3e-4) << name(m, wo);
      const bool mirror = width(m) <= 0.01f && cosine >= 0.2f;
      EXPECT_GE(albedo, mirror ? 0.995 : 0.3) << name(m, wo);
      const bool diffuse = std::holds_alternative<Diffuse>(m);
      EXPECT_NEAR(diffuse ? albedo : 1.0, 1, 1e-3) << name(m, wo);
      RunningStats weights;
      TestRandom random(5);
      for (int i = 0; i < 20000; ++i) {
        const auto s = sample_bsdf(m, wo, random.unit2());
        weights.add(s ? s->weight.x : 0.0);
        ASSERT_LE(s ? s->weight.x : 0.0f, 1 + 1e-5f) << name(m, wo);
      }
      EXPECT_GT(mean_p_value(weights, albedo, 3e-4), level) << name(m, wo);
    }
}

// Down to roughness 0.03 and a viewer at 1e-4 over the horizon.
TEST(Bsdf, ExtremesGiveFiniteSamples) {
  for (const Material& m : materials(Fresnel::schlick, Rgb(0.9f)))
    for (float cosine : {1.0f, 0.5f, 0.01f, 1e-4f, 1e-7f})
      for (float phi : {0.0f, 0.7f, kPi, -kPi / 2}) {
        const Vec3 wo = at_cosine(cosine, phi);
        for (float x : kExtremes)
          for (float y : kExtremes) {
            const auto s = sample_bsdf(m, wo, {x, y});
            if (!s) continue;
            ASSERT_TRUE(s->wi.z > 0 && std::isfinite(s->pdf_w) && s->pdf_w > 0) << name(m, wo);
            ASSERT_NEAR(length(s->wi), 1, 1e-6) << name(m, wo);
            const float pdf_w = bsdf_pdf_w(m, wo, s->wi);
            ASSERT_TRUE(std::isfinite(pdf_w) && pdf_w >= 0) << name(m, wo);
            for (int c = 0; c < 3; ++c) {
              ASSERT_TRUE(s->weight[c] >= 0 && s->weight[c] <= 1 + 1e-5f) << name(m, wo);
              ASSERT_TRUE(std::isfinite(eval_cos(m, wo, s->wi)[c])) << name(m, wo);
            }
          }
      }
}

}  // namespace
}  // namespace raytracing
