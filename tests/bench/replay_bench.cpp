// How near rendering comes to its limit: the time of the program over the time in which Embree
// alone answers exactly the same queries, on as many threads. Queries of the occluder tree, which
// shared paths ask, are not Embree's: they count as the program's own time.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/recorded_rays.h"
#include "raytracing/io/scene_file.h"
#include "raytracing/render/render.h"
#include "raytracing/study/metrics/statistics.h"

namespace raytracing {
namespace {

constexpr int kSize = 256;  // pixels
constexpr int kSpp = 16;
constexpr int kThreads = 2;
constexpr int kRounds = 7;

const std::filesystem::path kSource = RAYTRACING_SOURCE_DIR;

RecordedRays record(const Scene& scene, int reuse) {
  RenderOptions options;
  options.width = options.height = kSize;
  options.spp = kSpp;
  options.reuse = reuse;
  options.path.method = &direct_method("point");
  const std::atomic<bool> stop = false;
  start_recording();
  render(scene, options, stop, nullptr);
  return stop_recording();
}

// Seconds of rendering, as the program itself tells.
double run_program(const std::filesystem::path& scene, int reuse) {
  const auto folder = std::filesystem::temp_directory_path();
  const auto id = std::to_string(reinterpret_cast<std::uintptr_t>(&folder));
  const auto picture = folder / ("replay_bench" + id + ".png");
  const auto stats = folder / ("replay_bench" + id + ".json");
  const std::string command = fmt::format(
      "'{}' '{}' --width {} --height {} --spp {} --threads {} --reuse {} --light-sampling point "
      "--quiet --output '{}' --stats '{}'",
      RAYTRACING_PROGRAM, scene.string(), kSize, kSize, kSpp, kThreads, reuse, picture.string(),
      stats.string());
  if (std::system(command.c_str()) != 0) throw std::runtime_error("cannot run: " + command);
  std::ifstream file(stats);
  const double seconds = nlohmann::json::parse(file).at("render_seconds");
  file.close();
  std::filesystem::remove(picture);
  std::filesystem::remove(stats);
  return seconds;
}

void measure(const std::string& name, int reuse) {
  const std::filesystem::path path = kSource / "scenes" / (name + ".toml");
  LoadReport report;
  SceneFile file = load_scene_file(path.string(), direct_method_names(), report);
  const Scene scene(std::move(file.scene), kThreads, reuse > 1);  // as the program
  const RecordedRays recorded = record(scene, reuse);
  std::vector<double> renders, replays, ratios;
  for (int round = 0; round < kRounds; ++round) {
    renders.push_back(run_program(path, reuse));
    replays.push_back(recorded.replay(kThreads));
    ratios.push_back(renders.back() / replays.back());
  }
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  fmt::print("| {} | {} | {:.2f} | {:.3f} | {:.3f} | {:.2f} ({:.2f} to {:.2f}) |\n", name, reuse,
             1e-6 * static_cast<double>(recorded.rays.size()), median(renders), median(replays),
             median(ratios), *least, *most);
  std::fflush(stdout);
}

}  // namespace
}  // namespace raytracing

int main() {
  fmt::print(
      "Render time over the time of Embree alone for the same rays: {0}x{0} pixels, {1} "
      "spp, {2} threads; medians of {3} rounds in turns.\n\n"
      "| scene | reuse | million rays | render s | replay s | ratio (range) |\n"
      "|---|---|---|---|---|---|\n",
      raytracing::kSize, raytracing::kSpp, raytracing::kThreads, raytracing::kRounds);
  for (const char* scene : {"cornell", "glossy", "teapot_diffuse"})
    for (const int reuse : {1, 16}) raytracing::measure(scene, reuse);
}
