// A picture is a function of scene, options and seed: not of threads, tiles or order.

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/films.h"
#include "support/rooms.h"
#include "support/scenes.h"

namespace raytracing {
namespace {

RenderOptions options_of(SamplerKind sampler) {
  RenderOptions options;
  options.width = 37;
  options.height = 23;
  options.spp = 21;
  options.path.method = &direct_methods()[0];
  options.sampler = sampler;
  options.seed = 7;
  return options;
}

constexpr SamplerKind kSamplers[]{SamplerKind::sobol, SamplerKind::independent};

TEST(Determinism, PictureDependsNeitherOnThreadsNorOnTiles) {
  const Scene scene = metal_ball_room();
  for (const SamplerKind sampler : kSamplers)
    for (const DirectMethod& method : direct_methods()) {
      RenderOptions options = options_of(sampler);
      options.path.method = &method;
      const RenderResult first = render_all(scene, options);
      EXPECT_TRUE(first.complete);
      EXPECT_GT(first.film.mean().x, 0.01);
      for (const int threads : {1, 2, 7})
        for (const int tile_size : {8, 16, 33}) {
          options.threads = threads;
          options.tile_size = tile_size;
          const RenderResult other = render_all(scene, options);
          EXPECT_EQ(differing_pixels(first.film, other.film), 0)
              << method.name << ", " << threads << " threads, tile size " << tile_size;
          EXPECT_EQ(other.paths, 37u * 23u * 21u);
          EXPECT_EQ(other.rays.closest, first.rays.closest);
          EXPECT_EQ(other.rays.shadow, first.rays.shadow);
        }
    }
}

TEST(Determinism, SeedSamplerAndMethodMakeDifferentPictures) {
  const Scene scene = metal_ball_room();
  const RenderOptions options = options_of(SamplerKind::sobol);
  RenderOptions seed = options, sampler = options, method = options;
  ++seed.seed;
  sampler.sampler = SamplerKind::independent;
  method.path.method = &direct_methods()[1];
  const RenderResult first = render_all(scene, options);
  for (const RenderOptions& other : {seed, sampler, method})
    EXPECT_GT(differing_pixels(first.film, render_all(scene, other).film), 37 * 23 / 2);
}

// The place within the pixel, told by where the camera ray meets a plane, never repeats.
TEST(Determinism, EachSampleOfEachPixelHasItsOwnNumbers) {
  SceneMaker maker;
  maker.add_polygon(parallelogram(Vec3(0.0f), {4, 0, 0}, {0, 4, 0}), maker.add_surface(Diffuse{}));
  maker.description.camera = {Vec3(0, 0, 1), Vec3(0.0f), Vec3(0, 1, 0), 90};
  const Scene scene = maker.build();
  for (const SamplerKind sampler : kSamplers) {
    RenderOptions options = options_of(sampler);
    options.width = options.height = 8;
    std::vector<Vec2> places;
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        for (std::uint64_t i = 0; i < 4; ++i) {
          const PathLog log = trace_sample(scene, options, {x, y, i}).log;
          ASSERT_FALSE(log.steps.empty());
          const Vec3 p = log.steps[0].position;
          const Vec2 place(4 * (p.x + 1) - static_cast<float>(x),
                           4 * (1 - p.y) - static_cast<float>(y));
          EXPECT_TRUE(place.x > -1e-4f && place.x < 1.0001f && place.y > -1e-4f &&
                      place.y < 1.0001f);
          for (const Vec2& other : places) EXPECT_GT(length(place - other), 1e-5f);
          places.push_back(place);
        }
  }
}

TEST(Determinism, TraceSampleIsWhatRenderAdds) {
  const Scene scene = metal_ball_room();
  for (const SamplerKind sampler : kSamplers) {
    RenderOptions options = options_of(sampler);
    options.threads = 2;
    const RenderResult result = render_all(scene, options);
    RayCounts rays;
    for (int y = 0; y < options.height; ++y)
      for (int x = 0; x < options.width; ++x) {
        Film::Pixel pixel;
        for (std::uint64_t i = 0; i < options.spp; ++i) {
          const TracedSample traced = trace_sample(scene, options, {x, y, i});
          pixel.add(traced.radiance);
          rays += traced.rays;
        }
        EXPECT_TRUE(same_pixel(pixel, result.film.at(x, y))) << x << ", " << y;
      }
    EXPECT_EQ(rays.closest, result.rays.closest);
    EXPECT_EQ(rays.shadow, result.rays.shadow);
  }
}

// Samples are numbered, so that a longer render only adds to a shorter one.
TEST(Determinism, FewerSamplesAreTheFirstOnesOfMore) {
  const Scene scene = metal_ball_room();
  RenderOptions options = options_of(SamplerKind::sobol);
  options.spp = 5;
  const RenderResult result = render_all(scene, options);
  options.spp = 50;
  Film::Pixel pixel;
  for (std::uint64_t i = 0; i < 5; ++i)
    pixel.add(trace_sample(scene, options, {11, 13, i}).radiance);
  EXPECT_TRUE(same_pixel(pixel, result.film.at(11, 13)));
}

TEST(Determinism, ARenderStoppedEarlyHoldsWholePasses) {
  const Scene scene = metal_ball_room();
  RenderOptions options = options_of(SamplerKind::sobol);
  options.spp = 40;  // passes end at 16, 32 and 40
  options.tile_size = 8;
  const RenderResult whole = render_all(scene, options);
  for (const int threads : {1, 3}) {
    options.threads = threads;
    std::atomic<bool> stop = false;
    const RenderResult part =
        render(scene, options, stop, [&](std::uint64_t done, std::uint64_t total) {
          EXPECT_EQ(total, whole.paths);
          if (done > total / 2) stop = true;
        });
    EXPECT_FALSE(part.complete);
    EXPECT_LT(part.paths, whole.paths);
    EXPECT_GT(part.paths, whole.paths / 2);
    std::uint64_t paths = 0;
    for (int y = 0; y < options.height; ++y)
      for (int x = 0; x < options.width; ++x) {
        const Film::Pixel& pixel = part.film.at(x, y);
        EXPECT_TRUE(pixel.samples == 0 || pixel.samples == 16 || pixel.samples == 32 ||
                    pixel.samples == 40);
        Film::Pixel same;
        for (std::uint64_t i = 0; i < pixel.samples; ++i)
          same.add(trace_sample(scene, options, {x, y, i}).radiance);
        EXPECT_TRUE(same_pixel(same, pixel));
        paths += pixel.samples;
      }
    EXPECT_EQ(paths, part.paths);
  }
}

TEST(Determinism, ARenderStoppedBeforeItStartsIsEmpty) {
  const Scene scene = metal_ball_room();
  const std::atomic<bool> stop = true;
  const RenderResult result = render(scene, options_of(SamplerKind::sobol), stop, {});
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.paths, 0u);
  EXPECT_EQ(result.film.mean(), DVec3(0.0));
}

// Other threads wait for the passes of a tile before; they must not wait for one that never ends.
TEST(Determinism, AMethodThatThrowsEndsTheRender) {
  DirectMethod method = direct_methods()[0];
  method.estimate = [](const DirectQuery& query, RayQueries&, DirectEstimate&) {
    if (query.u.x > 0.99f) throw std::runtime_error("no estimate");
  };
  const Scene scene = metal_ball_room();
  RenderOptions options = options_of(SamplerKind::sobol);
  options.path.method = &method;
  for (const int reuse : {1, 16})
    for (const int threads : {1, 4}) {
      options.reuse = reuse;
      options.threads = threads;
      EXPECT_THROW(render_all(scene, options), std::runtime_error);
    }
}

TEST(RenderOptions, AreChecked) {
  const Scene scene = metal_ball_room();
  RenderOptions options = options_of(SamplerKind::sobol);
  options.tile_size = 0;
  EXPECT_THROW(render_all(scene, options), std::invalid_argument);
  options = options_of(SamplerKind::sobol);
  options.path.method = nullptr;
  EXPECT_THROW(render_all(scene, options), std::invalid_argument);
}

TEST(Progress, NeverFallsBackAndEndsAtTheTotal) {
  const Scene scene = metal_ball_room();
  RenderOptions options = options_of(SamplerKind::sobol);
  std::uint64_t last = 0;
  const std::atomic<bool> stop = false;
  render(scene, options, stop, [&](std::uint64_t done, std::uint64_t total) {
    EXPECT_EQ(total, 37u * 23u * 21u);
    EXPECT_GT(done, last);
    last = done;
  });
  EXPECT_EQ(last, 37u * 23u * 21u);
}

}  // namespace
}  // namespace raytracing
