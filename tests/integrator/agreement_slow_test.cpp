// The unbiased methods render the same pictures, and the Cornell box has its known brightness.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "raytracing/io/scene_file.h"
#include "raytracing/render/render.h"
#include "support/p_values.h"

namespace raytracing {
namespace {

constexpr int kThreads = 2;

std::vector<std::string> scene_files() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(RAYTRACING_SOURCE_DIR "/scenes"))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

Scene load(const std::string& path) {
  LoadReport report;
  return Scene(load_scene_file(path, direct_method_names(), report).scene, kThreads);
}

Film render_film(const Scene& scene, const DirectMethod& method, SamplerKind sampler, int size,
                 std::uint64_t spp, std::uint64_t seed) {
  RenderOptions options;
  options.width = options.height = size;
  options.spp = spp;
  options.shade.method = &method;
  options.sampler = sampler;
  options.seed = seed;
  options.threads = kThreads;
  const std::atomic<bool> stop = false;
  const RenderResult result = render(scene, options, stop, {});
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.non_finite_samples, 0u);
  return result.film;
}

/// Variance of Film::mean() for independent samples.
DVec3 variance_of_mean(const Film& film) {
  DVec3 sum(0.0);
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) sum += film.at(x, y).variance_of_mean();
  const double n = static_cast<double>(film.width()) * film.height();
  return sum / (n * n);
}

TEST(Agreement, UnbiasedMethodsRenderEqualMeansOfEveryScene) {
  struct Picture {
    std::string method;
    DVec3 mean, variance;
  };
  PValues p_values;
  const std::vector<std::string> paths = scene_files();
  ASSERT_GE(paths.size(), 7u);
  for (const std::string& path : paths) {
    const Scene scene = load(path);
    std::vector<Picture> pictures;
    for (const DirectMethod& method : direct_methods()) {
      if (!method.unbiased) continue;
      // Seeds of their own: shared numbers would tie the methods' errors together.
      const Film film = render_film(scene, method, SamplerKind::independent, 48, 160,
                                    100 + pictures.size());
      const Picture picture{std::string(method.name), film.mean(), variance_of_mean(film)};
      // No vacuous agreement: half a percent would be seen.
      EXPECT_LT(std::sqrt(picture.variance.x), 0.005 * picture.mean.x) << path;
      for (const Picture& other : pictures)
        for (int c = 0; c < 3; ++c)
          p_values.add(path + ": " + other.method + " and " + picture.method + ", channel " +
                           std::to_string(c),
                       normal_p_value((other.mean[c] - picture.mean[c]) /
                                      std::sqrt(other.variance[c] + picture.variance[c])));
      pictures.push_back(picture);
    }
  }
  p_values.expect_all();
}

TEST(Agreement, CornellBoxHasItsKnownBrightness) {
  const Scene scene = load(RAYTRACING_SOURCE_DIR "/scenes/cornell.toml");
  const DVec3 known(0.53241, 0.39454, 0.27249);
  for (const DirectMethod& method : direct_methods()) {
    if (!method.unbiased) continue;
    const DVec3 mean = render_film(scene, method, SamplerKind::sobol, 256, 64, 0).mean();
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(mean[c] / known[c], 1, 0.002) << method.name << ", channel " << c;
  }
}

}  // namespace
}  // namespace raytracing
