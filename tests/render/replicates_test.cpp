// Replicates: parts of the samples, each with scrambles of its own.

#include <gtest/gtest.h>

#include "raytracing/io/scene_file.h"
#include "support/films.h"

namespace raytracing {
namespace {

Scene cornell() {
  LoadReport report;
  const std::string path = std::string(RAYTRACING_SOURCE_DIR) + "/scenes/cornell.toml";
  return Scene(load_scene_file(path, direct_method_names(), report).scene, 1);
}

RenderOptions options_of(std::uint64_t spp, std::uint64_t replicates) {
  RenderOptions options;
  options.width = 13;
  options.height = 9;
  options.tile_size = 8;
  options.spp = spp;
  options.replicates = replicates;
  options.seed = 7;
  options.path.method = &direct_method("solid-angle");
  return options;
}

template <class Check>
void for_each_pixel(const Film& film, const Check& check) {
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) check(x, y, film.at(x, y));
}

constexpr SamplerKind kSamplers[]{SamplerKind::sobol, SamplerKind::independent};

TEST(Replicates, MeanAndVarianceAreThoseOfTheirMeans) {
  const Scene scene = cornell();
  for (const SamplerKind sampler : kSamplers) {
    RenderOptions options = options_of(60, 5);  // replicates of 12 cross the passes of 16
    options.sampler = sampler;
    const RenderResult result = render_all(scene, options);
    double spread = 0;
    for_each_pixel(result.film, [&](int x, int y, const Film::Pixel& pixel) {
      DVec3 mean(0.0), squares(0.0);
      std::vector<DVec3> means(5, DVec3(0.0));
      for (std::uint64_t i = 0; i < 60; ++i)
        means[i / 12] += DVec3(trace_sample(scene, options, {x, y, i}).radiance) / 12.0;
      for (const DVec3& m : means) mean += m / 5.0;
      for (const DVec3& m : means) squares += (m - mean) * (m - mean);
      EXPECT_EQ(pixel.samples, 60u);
      EXPECT_EQ(pixel.replicates, 5u);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(pixel.mean()[c], mean[c], 1e-13 * mean[c]);
        EXPECT_NEAR(pixel.variance_of_mean()[c], squares[c] / 4 / 5, 1e-13 * mean[c] * mean[c]);
        spread += squares[c];
      }
    });
    EXPECT_GT(spread, 0);
    EXPECT_EQ(result.film.fewest_replicates(), 5u);
  }
}

TEST(Replicates, PictureDependsNeitherOnThreadsNorOnTiles) {
  const Scene scene = cornell();
  for (const SamplerKind sampler : kSamplers) {
    RenderOptions options = options_of(40, 4);
    options.sampler = sampler;
    const RenderResult first = render_all(scene, options);
    for (const int threads : {2, 7})
      for (const int tile_size : {3, 16}) {
        options.threads = threads;
        options.tile_size = tile_size;
        EXPECT_EQ(differing_pixels(first.film, render_all(scene, options).film), 0)
            << threads << " threads, tile size " << tile_size;
      }
  }
}

// One replicate, and the first one of many, is what there was without replicates.
TEST(Replicates, TheFirstIsTheShorterPicture) {
  const Scene scene = cornell();
  for (const SamplerKind sampler : kSamplers) {
    RenderOptions one = options_of(8, 1), four = options_of(32, 4);
    one.sampler = four.sampler = sampler;
    for (std::uint64_t i = 0; i < 8; ++i)
      EXPECT_EQ(trace_sample(scene, one, {6, 5, i}).radiance,
                trace_sample(scene, four, {6, 5, i}).radiance);
  }
}

// No sample repeats: neither between the replicates nor within one.
TEST(Replicates, EachSampleHasItsOwnNumbers) {
  for (const SamplerKind sampler : kSamplers) {
    std::vector<Vec2> seen;
    for (std::uint64_t replicate = 0; replicate < 16; ++replicate)
      for (std::uint64_t i = 0; i < 16; ++i) {
        const Vec2 u = PathSampler(sampler, 3, 4, 5, i, replicate).pair(2);
        for (const Vec2& other : seen) EXPECT_GT(length(u - other), 1e-6f);
        seen.push_back(u);
      }
  }
}

TEST(Replicates, AnIncompleteOneCountsForNothingAfterTheFirst) {
  const Scene scene = cornell();
  RenderOptions options = options_of(96, 4);  // ends at 24, 48, ...; passes end at 16, 32, ...
  for (const std::uint64_t passes : {1, 2, 4}) {
    std::atomic<bool> stop = false;
    const RenderResult part =
        render(scene, options, stop,
               [&](std::uint64_t done, std::uint64_t total) { stop = done * 6 >= total * passes; });
    EXPECT_FALSE(part.complete);
    const std::uint64_t complete = passes * 16 / 24;
    EXPECT_EQ(part.film.fewest_replicates(), complete);
    RenderOptions short_options =
        options_of(complete > 0 ? 24 * complete : 16, complete > 0 ? complete : 1);
    const RenderResult shorter = render_all(scene, short_options);
    for_each_pixel(part.film, [&](int x, int y, const Film::Pixel& pixel) {
      const Film::Pixel& same = shorter.film.at(x, y);
      EXPECT_EQ(pixel.samples, passes * 16);
      EXPECT_NEAR(pixel.mean().x, same.mean().x, 1e-13 * same.mean().x);
      EXPECT_EQ(pixel.variance_of_mean(),
                complete > 1 ? same.variance_of_mean() : DVec3(0.0));  // 0: not known
    });
  }
}

}  // namespace
}  // namespace raytracing
