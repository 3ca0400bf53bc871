// The unbiased methods render the same pictures, and the Cornell box has its known brightness.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
  options.path.method = &method;
  options.sampler = sampler;
  options.seed = seed;
  options.threads = kThreads;
  const std::atomic<bool> stop = false;
  const RenderResult result = render(scene, options, stop, {});
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.non_finite_samples, 0u);
  return result.film;
}

/// Statistics by channel of the differences of numbers that belong together.
std::array<RunningStats, 3> differences(const std::vector<DVec3>& a, const std::vector<DVec3>& b) {
  std::array<RunningStats, 3> stats;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int c = 0; c < 3; ++c) stats[c].add(a[i][c] - b[i][c]);
  return stats;
}

// Two methods with the same seed see the same camera rays and bounces: the difference of their
// pictures is less noisy than either. Many pictures of few samples tell its spread.
TEST(Agreement, UnbiasedMethodsRenderEqualMeansOfEveryScene) {
  constexpr int kPictures = 200;
  PValues p_values;
  const std::vector<std::string> paths = scene_files();
  ASSERT_GE(paths.size(), 7u);
  for (const std::string& path : paths) {
    const Scene scene = load(path);
    std::map<std::string, std::vector<DVec3>> means;
    for (const DirectMethod& method : direct_methods()) {
      if (!method.unbiased) continue;
      std::vector<DVec3> own;
      for (int seed = 0; seed < kPictures; ++seed)
        own.push_back(render_film(scene, method, SamplerKind::independent, 48, 1, seed).mean());
      for (const auto& [name, other] : means) {
        const auto stats = differences(own, other);
        for (int c = 0; c < 3; ++c) {
          p_values.add(path + ": " + std::string(method.name) + " and " + name + ", channel " +
                           std::to_string(c),
                       mean_p_value(stats[c], 0));
          // No vacuous agreement: one percent would be seen.
          EXPECT_LT(5 * stats[c].standard_error(), 0.01 * own[0][c]) << path;
        }
      }
      means[std::string(method.name)] = std::move(own);
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
