// A picture whose pixels share paths is a function of scene, options and seed too.

#include <gtest/gtest.h>

#include "support/films.h"
#include "support/scenes.h"

namespace raytracing {
namespace {

/// A room with a metal ball on a sphere, and metal walls at two sides.
Scene room(bool with_occluders = true) {
  SceneMaker maker;
  const auto wall = maker.add_surface(Diffuse{Rgb(0.7f, 0.5f, 0.3f)});
  const auto light = maker.add_surface(Diffuse{Rgb(0.0f)}, Rgb(5.0f, 4.0f, 3.0f));
  const auto metal = maker.add_surface(GgxConductor{Rgb(0.9f), 0.16f});
  maker.description.meshes.push_back(inward_box(1, wall));
  maker.add_polygon(parallelogram({0, 0.95f, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}), light);
  maker.add_sphere({0.2f, -0.6f, -0.2f}, 0.4f, metal);
  maker.description.camera = {{0.0f, 0.1f, 0.95f}, {0.0f, -0.1f, 0.0f}, {0.0f, 1.0f, 0.0f}, 70};
  return Scene(std::move(maker.description), 1, with_occluders);
}

RenderOptions options_of(int reuse) {
  RenderOptions options;
  options.width = 13;
  options.height = 9;
  options.spp = 6;
  options.reuse = reuse;
  options.path.method = &direct_method("solid-angle");
  options.seed = 7;
  return options;
}

TEST(Reuse, PictureDependsNeitherOnThreadsNorOnTiles) {
  const Scene scene = room();
  for (const DirectMethod& method : direct_methods())
    for (const int reuse : {2, 4, 8, 16})
      for (const std::uint64_t replicates : {1, 3}) {
        RenderOptions options = options_of(reuse);
        options.width = 37;
        options.height = 23;
        options.path.method = &method;
        options.replicates = replicates;
        const RenderResult first = render_all(scene, options);
        EXPECT_TRUE(first.complete);
        EXPECT_EQ(first.non_finite_samples, 0u);
        for (const auto& [threads, tile_size] : {std::pair{2, 16}, {5, 3}, {5, 33}}) {
          options.threads = threads;
          options.tile_size = tile_size;
          const RenderResult other = render_all(scene, options);
          EXPECT_EQ(differing_pixels(first.film, other.film), 0)
              << method.name << ", reuse " << reuse << ", " << threads << " threads";
          EXPECT_EQ(other.paths, 37u * 23u * 6u);
          EXPECT_EQ(other.rays.shadow, first.rays.shadow);
          EXPECT_EQ(other.rays.shafts, first.rays.shafts);
        }
      }
}

// A replay traces the whole group again; its log tells where the radiance comes from.
TEST(Reuse, TraceSampleIsWhatRenderAdds) {
  const Scene scene = room();
  for (const int reuse : {2, 16}) {
    const RenderOptions options = options_of(reuse);
    const RenderResult result = render_all(scene, options);
    for (int y = 0; y < options.height; ++y)
      for (int x = 0; x < options.width; ++x) {
        Film::Pixel pixel;
        for (std::uint64_t i = 0; i < options.spp; ++i) {
          const auto& [radiance, log, rays] = trace_sample(scene, options, {x, y, i});
          pixel.add(radiance);
          Rgb logged(0.0f);
          for (const PathLog::Step& step : log.steps) logged += step.emitted + step.direct;
          for (int c = 0; c < 3; ++c) EXPECT_NEAR(logged[c], radiance[c], 1e-5f * radiance[c]);
        }
        EXPECT_TRUE(same_pixel(pixel, result.film.at(x, y))) << x << ", " << y;
      }
  }
}

// Shafts and single rays tell the same but where a ray grazes an edge.
TEST(Reuse, ShaftsTellWhatRaysTell) {
  RenderOptions options = options_of(16);
  options.width = options.height = 40;
  const RenderResult by_shafts = render_all(room(), options);
  const RenderResult by_rays = render_all(room(false), options);
  EXPECT_GT(by_shafts.rays.shafts, 1000u);
  EXPECT_EQ(by_rays.rays.shafts, 0u);
  EXPECT_LT(by_shafts.rays.shadow, by_rays.rays.shadow / 2);
  int differing = 0;
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x) {
      const DVec3 a = by_shafts.film.at(x, y).mean(), b = by_rays.film.at(x, y).mean();
      differing += length(a - b) > 1e-4 * length(b) ? 1 : 0;
    }
  EXPECT_LE(differing, options.width * options.height / 100);
}

TEST(Reuse, HasNothingToDoForDirectLight) {
  const Scene scene = room();
  RenderOptions off = options_of(1), on = options_of(4);
  off.path.max_depth = on.path.max_depth = 1;
  EXPECT_EQ(differing_pixels(render_all(scene, off).film, render_all(scene, on).film), 0);
  off.path.max_depth = on.path.max_depth = 2;
  EXPECT_GT(differing_pixels(render_all(scene, off).film, render_all(scene, on).film), 100);
}

TEST(Reuse, ARenderStoppedEarlyHoldsWholeSamples) {
  const Scene scene = room();
  RenderOptions options = options_of(4);
  options.width = options.height = 40;
  options.spp = 30;
  options.tile_size = 8;
  options.threads = 3;
  std::atomic<bool> stop = false;
  const RenderResult part =
      render(scene, options, stop, [&](std::uint64_t done, std::uint64_t total) {
        EXPECT_EQ(total, 40u * 40u * 30u);
        if (done > total / 2) stop = true;
      });
  EXPECT_FALSE(part.complete);
  std::uint64_t paths = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const Film::Pixel& pixel = part.film.at(x, y);
      paths += pixel.samples;
      if ((x + y) % 7 != 0) continue;
      Film::Pixel same;
      for (std::uint64_t i = 0; i < pixel.samples; ++i)
        same.add(trace_sample(scene, options, {x, y, i}).radiance);
      EXPECT_TRUE(same_pixel(same, pixel));
    }
  EXPECT_EQ(paths, part.paths);
}

// A path that overflows reaches many pixels of its group.
TEST(Reuse, CausesOfNonFiniteSamplesDependNeitherOnThreadsNorOnTiles) {
  SceneMaker maker;
  maker.description.meshes.push_back(
      inward_box(1, maker.add_surface(GgxConductor{Rgb(0.9f), 0.3f})));
  const auto light = maker.add_surface(Diffuse{Rgb(0.0f)}, Rgb(3e38f, 1e37f, 1));
  maker.add_polygon(parallelogram({0, 0.95f, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}), light);
  maker.description.camera = {{0.0f, 0.1f, 0.95f}, {0.0f, -0.1f, 0.0f}, {0.0f, 1.0f, 0.0f}, 70};
  const Scene scene = maker.build();
  for (const int reuse : {1, 16}) {
    RenderOptions options = options_of(reuse);
    const RenderResult first = render_all(scene, options);
    ASSERT_GT(first.non_finite_samples, 8u);
    for (const auto& [threads, tile_size] : {std::pair{2, 16}, {5, 3}, {5, 33}}) {
      options.threads = threads;
      options.tile_size = tile_size;
      const RenderResult other = render_all(scene, options);
      EXPECT_EQ(other.non_finite_by_cause, first.non_finite_by_cause);
      ASSERT_EQ(other.first_non_finite.size(), 8u);
      for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(other.first_non_finite[i].cause, first.first_non_finite[i].cause);
        EXPECT_EQ(other.first_non_finite[i].index.sample, first.first_non_finite[i].index.sample);
      }
    }
  }
}

}  // namespace
}  // namespace raytracing
