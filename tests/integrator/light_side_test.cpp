// Lights shine on the side of their normal only.

#include <gtest/gtest.h>

#include "raytracing/integrator/shade.h"
#include "support/scenes.h"

namespace raytracing {
namespace {

const Rgb kEmitted(1.0f, 2.0f, 3.0f);
const Vec3 kX(1.0f, 0.0f, 0.0f), kY(0.0f, 1.0f, 0.0f), kZ(0.0f, 0.0f, 1.0f);

Rgb sum_of_samples(const Scene& scene, const DirectMethod& method, const Ray& ray,
                   std::optional<std::uint32_t> max_depth = {}) {
  Visibility visibility(scene);
  Rgb sum(0.0f);
  for (int i = 0; i < 500; ++i) {
    PathSampler sampler(SamplerKind::independent, 3, 0, 0, i);
    sum += shade(scene, {&method, max_depth}, ray, sampler, visibility);
  }
  return sum;
}

/// A black light in the plane z = 1, shining down, and a receiver in the plane z = height.
Scene light_and_receiver(float height, const Material& receiver) {
  SceneMaker maker;
  const auto light = maker.add_surface(Diffuse{Rgb(0.0f)}, kEmitted);
  maker.add_polygon(parallelogram(kZ, kY, kX), light);
  maker.add_polygon(parallelogram(height * kZ, 4.0f * kX, 4.0f * kY), maker.add_surface(receiver));
  return maker.build();
}

const Material kReceivers[]{Diffuse{Rgb(0.8f)}, GgxConductor{Rgb(0.8f), 0.3f}};

TEST(LightSide, FrontShowsTheRadianceAndBackIsBlack) {
  const Scene scene = light_and_receiver(-1, Diffuse{Rgb(0.0f)});
  for (const DirectMethod& method : direct_methods()) {
    EXPECT_EQ(sum_of_samples(scene, method, {Vec3(0.1f, 0.2f, 0), kZ}), 500.0f * kEmitted);
    EXPECT_EQ(sum_of_samples(scene, method, {Vec3(0.1f, 0.2f, 2), -kZ}), Rgb(0.0f));
  }
}

TEST(LightSide, ReceiverInFrontGetsLightAndReceiverBehindGetsNone) {
  const Vec3 direction = normalize(Vec3(0.3f, 0.1f, -1));
  for (const Material& material : kReceivers) {
    const Scene front = light_and_receiver(-0.5f, material);
    const Scene behind = light_and_receiver(1.5f, material);
    for (const DirectMethod& method : direct_methods()) {
      // Both are seen from above: the first past the light's edge.
      EXPECT_GT(sum_of_samples(front, method, {Vec3(1.2f, 0, 0.9f), direction}).x, 1);
      EXPECT_EQ(sum_of_samples(behind, method, {Vec3(0.2f, 0, 2.5f), direction}), Rgb(0.0f));
      // The plane of the light faces the lower side of the receiver behind it, but shines away.
      EXPECT_EQ(sum_of_samples(behind, method, {Vec3(0.2f, 0, 1.2f), -direction}), Rgb(0.0f));
    }
  }
}

// The back of a light reflects like any surface; its own light cannot reach it.
TEST(LightSide, BackOfALightReflectsOtherLights) {
  SceneMaker maker;
  const auto light = maker.add_surface(Diffuse{Rgb(0.5f)}, kEmitted);
  maker.add_polygon(parallelogram(Vec3(0.0f), 0.2f * kY, 0.2f * kX), light);  // shines down
  maker.add_polygon(parallelogram(2.0f * kZ, kY, kX), light);                 // shines down on it
  const Scene scene = maker.build();
  for (const DirectMethod& method : direct_methods()) {
    const Rgb seen = sum_of_samples(scene, method, {Vec3(0.05f, 0.02f, 1), -kZ}, 1) / 500.0f;
    EXPECT_GT(seen.x, 0);
    EXPECT_LT(seen.x, 0.5f * kEmitted.x);
    EXPECT_NEAR(seen.y / seen.x, 2, 1e-5);
  }
}

// With several lights, each adds its own: the choice of a light is divided out.
TEST(LightSide, TwoLightsAddUp) {
  const Vec3 left(-1, 0, 1), right(1.2f, 0.3f, 1);
  const Ray ray{Vec3(0.02f, 0.01f, 0.5f), -kZ};
  for (const DirectMethod& method : direct_methods()) {
    Rgb sum(0.0f), both(0.0f);
    for (const int lights : {1, 2, 3}) {  // a set of bits: left, right
      SceneMaker maker;
      maker.add_polygon(parallelogram(Vec3(0.0f), 4.0f * kX, 4.0f * kY),
                        maker.add_surface(Diffuse{Rgb(0.8f)}));
      const auto dim = maker.add_surface(Diffuse{Rgb(0.0f)}, kEmitted);
      const auto bright = maker.add_surface(Diffuse{Rgb(0.0f)}, Rgb(9.0f, 1.0f, 4.0f));
      if (lights & 1) maker.add_polygon(parallelogram(left, 0.3f * kY, 0.2f * kX), dim);
      if (lights & 2) maker.add_polygon(parallelogram(right, 0.2f * kY, 0.2f * kX), bright);
      const Rgb one = sum_of_samples(maker.build(), method, ray, 1);
      (lights == 3 ? both : sum) += one;
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(both[c] / sum[c], 1, 0.15) << method.name;
  }
}

}  // namespace
}  // namespace raytracing
