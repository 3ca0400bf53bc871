// Lights shine on the side of their normal only.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "raytracing/integrator/path_tracer.h"
#include "support/p_values.h"
#include "support/scenes.h"
#include "support/single_paths.h"

namespace raytracing {
namespace {

const Rgb kEmitted(1.0f, 2.0f, 3.0f);
const Vec3 kX(1.0f, 0.0f, 0.0f), kY(0.0f, 1.0f, 0.0f), kZ(0.0f, 0.0f, 1.0f);

Rgb sum_of_samples(const Scene& scene, const DirectMethod& method, const Ray& ray,
                   std::optional<std::uint32_t> max_depth = {}) {
  SinglePaths paths(scene, {&method, max_depth});
  Rgb sum(0.0f);
  for (int i = 0; i < 500; ++i) {
    sum += paths.radiance(ray, PathSampler(SamplerKind::independent, 3, 0, 0, i));
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

/// A receiver under two lights of unequal size and radiance; each bit of `set` stands for one.
Scene under_two_lights(const Material& receiver, int set) {
  SceneMaker maker;
  maker.add_polygon(parallelogram(Vec3(0.0f), 0.01f * kX, 0.01f * kY), maker.add_surface(receiver));
  const auto dim = maker.add_surface(Diffuse{Rgb(0.0f)}, kEmitted);
  const auto bright = maker.add_surface(Diffuse{Rgb(0.0f)}, Rgb(9.0f));
  if (set & 1) maker.add_polygon(parallelogram({-0.4f, 0, 0.6f}, 0.5f * kY, 0.3f * kX), dim);
  if (set & 2) maker.add_polygon(parallelogram({0.4f, 0, 0.8f}, 0.2f * kY, 0.3f * kX), bright);
  return maker.build();
}

// The choice of a light is divided out, and the weights of light and BSDF sampling know of it.
TEST(LightSide, TwoLightsAddUp) {
  const Vec3 wo(0.48f, -0.36f, 0.8f);
  const Ray ray{0.1f * wo, -wo};
  PValues p_values;
  for (const Material& material : kReceivers)
    for (const DirectMethod& method : direct_methods()) {
      RunningStats stats[4];
      for (const int set : {1, 2, 3}) {
        const Scene scene = under_two_lights(material, set);
        SinglePaths paths(scene, {&method, 1});
        for (int i = 0; i < 100'000; ++i)
          stats[set].add(
              paths.radiance(ray, PathSampler(SamplerKind::independent, set, 0, 0, i)).x);
      }
      const double error = std::hypot(stats[1].standard_error(), stats[2].standard_error(),
                                      stats[3].standard_error());
      EXPECT_LT(error, 0.01 * stats[3].mean());
      p_values.add(std::string(method.name),
                   normal_p_value((stats[3].mean() - stats[1].mean() - stats[2].mean()) / error));
    }
  p_values.expect_all();
}

}  // namespace
}  // namespace raytracing
