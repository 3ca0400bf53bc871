// What DirectEstimate does with the light that methods add, and what it refuses.

#include "raytracing/integrator/direct_estimate.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "raytracing/integrator/direct_method.h"
#include "support/scenes.h"

namespace raytracing {
namespace {

/// A vertex at the origin, seen from above, whose shading normal leans towards +x by 45 degrees; a
/// light far above it.
struct Lean {
  explicit Lean(const Material& material, bool with_occluders = true) {
    const auto surface = maker.add_surface(material);
    const auto emitting = maker.add_surface(Diffuse{}, Rgb(1.0f));
    maker.add_polygon(parallelogram({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), surface);
    maker.add_polygon(parallelogram({0, 0, 9}, {1, 0, 0}, {0, -1, 0}), emitting);
    maker.description.camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 30};
    scene.emplace(maker.description, 1, with_occluders);
    rays.emplace(*scene);
    const Ray ray{{0, 0, 5}, {0, 0, -1}};
    vertex = scene->vertex(ray, *rays->closest_hit(ray));
    vertex.shading = Frame::around(normalize(Vec3(1, 0, 1)));
    vertex.wo = vertex.shading.to_local(Vec3(0, 0, 1));
  }

  DirectQuery query() const {
    return {vertex, scene->lights()[0], 0.5f, {0.5f, 0.5f}, sampler, 1, 4};
  }

  SceneMaker maker;
  std::optional<Scene> scene;
  std::optional<RayQueries> rays;
  Vertex vertex;
  PathSampler sampler = PixelSampler(SamplerKind::independent, 1).path(0, 0, 0, 0);
};

TEST(BalanceHeuristic, SharesOne) {
  EXPECT_EQ(balance_heuristic(3, 1), 0.75f);
  EXPECT_EQ(balance_heuristic(2, 0), 1);
  EXPECT_EQ(balance_heuristic(0, 2), 0);
  EXPECT_FLOAT_EQ(balance_heuristic(0.3f, 5) + balance_heuristic(5, 0.3f), 1);
}

// Both horizons end the light, of the vertex itself and of those that share its directions.
TEST(DirectEstimate, NothingComesFromBelowAHorizon) {
  Lean lean(GgxConductor{});
  std::vector<LightSample> samples;
  const DirectQuery query = lean.query();
  DirectEstimate estimate(query, true, *lean.rays, &samples);
  for (const Vec3& below : {Vec3(-0.8f, 0, 0.6f), Vec3(0.8f, 0, -0.6f)})
    estimate.add_direction(below, 1, 1);
  EXPECT_TRUE(samples.empty());
  EXPECT_EQ(estimate.radiance(), Rgb(0.0f));
  estimate.add_direction(Vec3(0.6f, 0, 0.8f), 1, 1);
  EXPECT_EQ(samples.size(), 1u);
  EXPECT_GT(estimate.radiance().x, 0);
}

// A direction that is black for the viewer of the vertex is recorded for the others, and counts no
// light.
TEST(DirectEstimate, BlackDirectionsAreRecorded) {
  Lean lean(Diffuse{Rgb(0.0f)});
  std::vector<LightSample> samples;
  const DirectQuery query = lean.query();
  DirectEstimate estimate(query, false, *lean.rays, &samples);
  estimate.add_point({0, 0, 9}, 2, 0.5f);
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(estimate.radiance(), Rgb(0.0f));
  EXPECT_EQ(samples[0].light, Rgb(0.5f));  // share Le / (pdf_w pmf)
  EXPECT_EQ(samples[0].light_pdf_w, 1);
}

TEST(DirectEstimate, UnusableDensitiesAddNothing) {
  Lean lean(Diffuse{});
  std::vector<LightSample> samples;
  const DirectQuery query = lean.query();
  DirectEstimate estimate(query, false, *lean.rays, &samples);
  for (const float pdf_w : {0.0f, -1.0f, std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()}) {
    estimate.add_point({0, 0, 9}, pdf_w);
    estimate.add_direction({0, 0, 1}, pdf_w, 1);
  }
  EXPECT_TRUE(samples.empty());
  EXPECT_EQ(estimate.radiance(), Rgb(0.0f));
}

// A method that asks for segments without saying so would find no occluder.
TEST(DirectEstimate, SegmentsNeedTheOccluderTree) {
  Lean lean(Diffuse{}, false);
  EXPECT_THROW(estimate_direct(direct_method("line"), lean.query(), *lean.rays), std::logic_error);
}

}  // namespace
}  // namespace raytracing
