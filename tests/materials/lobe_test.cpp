// What holds for every kind of material: its lobe in loops over shared paths, its samples, and the
// horizon.

#include "raytracing/materials/lobe.h"

#include <gtest/gtest.h>

#include "raytracing/materials/material.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

// Examples of each kind of material; a kind more needs a function more.
std::vector<Material> examples(const Diffuse&) { return {Diffuse{Rgb(0.9f, 0.5f, 0.1f)}}; }
std::vector<Material> examples(const GgxConductor&) {
  std::vector<Material> all;
  for (const Fresnel fresnel : {Fresnel::none, Fresnel::schlick})
    for (const float alpha : {0.01f, 0.1f, 0.5f, 1.0f})
      all.push_back(GgxConductor{Rgb(0.9f, 0.5f, 0.1f), alpha, fresnel});
  return all;
}

Vec3 above_horizon(TestRandom& random) {
  const Vec2 u = random.unit2();
  const float z = 0.02f + 0.98f * u.x, sine = std::sqrt(1 - z * z);
  return {sine * std::cos(2 * kPi * u.y), sine * std::sin(2 * kPi * u.y), z};
}

void expect_near(float value, float expected, const std::string& what) {
  EXPECT_NEAR(value, expected, 2e-4f * expected + 1e-6f) << what;
}

// Directions at random, half of them near the mirror direction, about a tilted normal.
void expect_same_lobe(const Material& material) {
  TestRandom random(5);
  const Frame frame = Frame::around(normalize(Vec3(0.3f, -0.8f, 0.5f)));
  const LobeShape shape = lobe_shape(material);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 wo = above_horizon(random);
    Vec3 wi = above_horizon(random);
    if (i % 2 == 0) wi = normalize(Vec3(-wo.x, -wo.y, wo.z) + 0.1f * wi);
    const Lobe l = lobe(shape.is_ggx, shape.alpha, shape.schlick, frame.z, frame.to_world(wo),
                        frame.to_world(wi));
    const Rgb f_cos = eval_cos(material, wo, wi);
    for (int c = 0; c < 3; ++c)
      expect_near(l.value * with_white(shape.reflectance[c], l.schlick), f_cos[c], "f cos");
    expect_near(l.pdf_w, bsdf_pdf_w(material, wo, wi), "density");
  }
}

template <class... Kinds>
void expect_same_lobes(const std::variant<Kinds...>*) {
  for (const std::vector<Material>& materials : {examples(Kinds{})...})
    for (const Material& material : materials) expect_same_lobe(material);
}

TEST(Lobe, IsThatOfTheMaterial) { expect_same_lobes(static_cast<const Material*>(nullptr)); }

template <class... Kinds>
void expect_black_below_the_horizon(const std::variant<Kinds...>*) {
  for (const std::vector<Material>& materials : {examples(Kinds{})...})
    for (const Material& material : materials)
      for (const Vec3& wi : {Vec3(0.6f, 0, -0.8f), Vec3(1, 0, 0), Vec3(0, 0, -1)}) {
        EXPECT_EQ(eval_cos(material, Vec3(0, 0.6f, 0.8f), wi), Rgb(0.0f));
        EXPECT_EQ(bsdf_pdf_w(material, Vec3(0, 0.6f, 0.8f), wi), 0);
      }
}

template <class... Kinds>
void expect_samples_with_their_weight(const std::variant<Kinds...>*) {
  TestRandom random(6);
  for (const std::vector<Material>& materials : {examples(Kinds{})...})
    for (const Material& material : materials)
      for (int i = 0; i < 500; ++i) {
        const Vec3 wo = above_horizon(random);
        const auto sample = sample_bsdf(material, wo, random.unit2());
        if (!sample) continue;
        expect_near(sample->pdf_w, bsdf_pdf_w(material, wo, sample->wi), "density of a sample");
        const Rgb f_cos = eval_cos(material, wo, sample->wi);
        for (int c = 0; c < 3; ++c)
          expect_near(sample->weight[c] * sample->pdf_w, f_cos[c], "f cos of a sample");
      }
}

TEST(Materials, SampleWithTheirDensityAndWeight) {
  expect_samples_with_their_weight(static_cast<const Material*>(nullptr));
}

TEST(Materials, AreBlackBelowTheHorizon) {
  expect_black_below_the_horizon(static_cast<const Material*>(nullptr));
}

TEST(Lobe, OfLambertianMaterialsIsTheCosine) {
  const LobeShape shape = lobe_shape(Material(Diffuse{}));
  const Vec3 n(0, 0, 1), wo(0, 0.6f, 0.8f), wi(0.6f, 0, 0.8f);
  const Lobe general = lobe(shape.is_ggx, shape.alpha, shape.schlick, n, wo, wi);
  const Lobe simple = lambertian_lobe(0.8f);
  EXPECT_EQ(general.value, simple.value);
  EXPECT_EQ(general.pdf_w, simple.pdf_w);
  EXPECT_EQ(general.schlick, simple.schlick);
}

}  // namespace
}  // namespace raytracing
