// Sharing paths changes the noise and not the picture: means of pictures, regions and pixels with
// and without it. The errors of neighbouring pixels are alike, so the spread is that between
// pictures of other seeds.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "raytracing/io/scene_file.h"
#include "raytracing/render/render.h"
#include "support/p_values.h"
#include "support/scenes.h"

namespace raytracing {
namespace {

constexpr int kPictures = 100;

RenderOptions options_of(const std::string& method, int reuse,
                         std::optional<std::uint32_t> max_depth) {
  RenderOptions options;
  options.width = 26;  // no multiple of any group
  options.height = 22;
  options.spp = 8;
  options.reuse = reuse;
  options.path.method = &direct_method(method);
  options.path.max_depth = max_depth;
  options.threads = 2;
  return options;
}

/// Sums over the whole picture and over each of `columns` x `rows` regions.
std::vector<DVec3> sums_of(const Film& film, int columns, int rows) {
  std::vector<DVec3> sums(columns * rows + 1, DVec3(0.0));
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      const DVec3 mean = film.at(x, y).mean();
      sums[0] += mean;
      sums[1 + y * rows / film.height() * columns + x * columns / film.width()] += mean;
    }
  return sums;
}

/// By region and channel, such sums of pictures of different seeds.
std::vector<RunningStats> measure(const Scene& scene, RenderOptions options,
                                  std::uint64_t first_seed, int columns = 3, int rows = 3) {
  std::vector<RunningStats> stats;
  for (int i = 0; i < kPictures; ++i) {
    options.seed = first_seed + i;
    const std::atomic<bool> stop = false;
    const RenderResult result = render(scene, options, stop, {});
    EXPECT_EQ(result.non_finite_samples, 0u);
    const std::vector<DVec3> sums = sums_of(result.film, columns, rows);
    stats.resize(3 * sums.size());
    for (std::size_t region = 0; region < sums.size(); ++region)
      for (int c = 0; c < 3; ++c) stats[3 * region + c].add(sums[region][c]);
  }
  return stats;
}

Scene shipped_scene(const std::string& path) {
  LoadReport report;
  return Scene(load_scene_file(path, direct_method_names(), report).scene, 2);
}

void compare(const std::string& name, const Scene& scene, const std::string& method,
             std::initializer_list<int> edges, std::optional<std::uint32_t> max_depth,
             PValues& p_values) {
  const auto off = measure(scene, options_of(method, 1, max_depth), 0);
  for (const int reuse : edges) {
    const auto on = measure(scene, options_of(method, reuse, max_depth), 1000 * reuse);
    for (std::size_t i = 0; i < on.size(); ++i)
      p_values.add(name + ", " + method + ", reuse " + std::to_string(reuse) + ", region " +
                       std::to_string(i / 3) + ", channel " + std::to_string(i % 3),
                   same_mean_p_value(off[i], on[i]));
  }
}

TEST(ReuseMeans, AreThoseWithoutOnEveryScene) {
  PValues p_values;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(RAYTRACING_SOURCE_DIR "/scenes"))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  ASSERT_GE(paths.size(), 7u);
  for (const std::filesystem::path& path : paths)
    compare(path.stem().string(), shipped_scene(path.string()), "solid-angle", {16}, std::nullopt,
            p_values);
  p_values.expect_all();
}

// 25,600 samples of each pixel: single pixels have rare bright paths, and with fewer samples means
// are not normal enough for the small level that so many comparisons ask for.
TEST(ReuseMeans, AreThoseWithoutInEveryPixel) {
  constexpr int kEdge = 13;
  PValues p_values;
  for (const std::string name : {"cornell", "glossy"}) {
    const Scene scene = shipped_scene(RAYTRACING_SOURCE_DIR "/scenes/" + name + ".toml");
    const auto measure_pixels = [&](int reuse) {
      RenderOptions options = options_of("point", reuse, std::nullopt);
      options.width = options.height = kEdge;
      options.spp = 256;
      return measure(scene, options, 1000 * reuse, kEdge, kEdge);
    };
    const auto off = measure_pixels(1), on = measure_pixels(8);
    for (std::size_t i = 3; i < on.size(); ++i)
      p_values.add(
          name + ", pixel " + std::to_string(i / 3 - 1) + ", channel " + std::to_string(i % 3),
          same_mean_p_value(off[i], on[i]));
  }
  p_values.expect_all();
}

// Both materials at both ends, a sphere and flat faces, lights that metal finds by its own bounces.
TEST(ReuseMeans, AreThoseWithoutForAllMethodsAndDepths) {
  SceneMaker maker;
  const auto wall = maker.add_surface(Diffuse{Rgb(0.7f, 0.5f, 0.3f)});
  const auto light = maker.add_surface(Diffuse{Rgb(0.4f)}, Rgb(5.0f, 4.0f, 3.0f));
  const auto metal = maker.add_surface(GgxConductor{Rgb(0.9f, 0.6f, 0.2f), 0.2f, Fresnel::schlick});
  const auto mirror = maker.add_surface(GgxConductor{Rgb(0.9f), 0.05f});
  maker.description.meshes.push_back(inward_box(1, wall));
  maker.add_polygon(parallelogram({0.2f, 0.95f, 0}, {0.6f, 0, 0}, {0, 0, 0.5f}), light);
  maker.add_polygon(parallelogram({0, -0.9f, 0}, {0, 0, 0.8f}, {0.8f, 0, 0}), metal);
  maker.add_sphere({0.3f, -0.5f, -0.2f}, 0.35f, metal);
  maker.add_sphere({-0.4f, -0.3f, -0.5f}, 0.3f, mirror);
  maker.description.camera = {{0.0f, 0.1f, 0.95f}, {0.0f, -0.2f, 0.0f}, {0.0f, 1.0f, 0.0f}, 80};
  const Scene scene = maker.build();
  PValues p_values;
  for (const DirectMethod& method : direct_methods())
    compare("room", scene, std::string(method.name), {2, 16}, std::nullopt, p_values);
  compare("room, depth 2", scene, "solid-angle", {8}, 2, p_values);
  compare("room, depth 3", scene, "point", {8}, 3, p_values);
  p_values.expect_all();
}

}  // namespace
}  // namespace raytracing
