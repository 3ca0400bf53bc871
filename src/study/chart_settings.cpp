#include "raytracing/study/chart_settings.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"

namespace raytracing {
namespace {

constexpr int kReuse = 1;  // paths that pixels share hide what the methods do

}  // namespace

std::uint64_t run_seed(std::uint64_t spp, std::uint64_t repetition) {
  return (spp << 20) + repetition;
}

std::vector<PlannedRun> plan_runs(const ChartSettings& settings) {
  std::vector<PlannedRun> runs;
  std::size_t turn = 0;
  for (std::uint64_t repetition = 0; repetition < settings.seeds; ++repetition)
    for (const std::uint64_t spp : settings.spp) {
      for (std::size_t i = 0; i < settings.methods.size(); ++i)
        runs.push_back({settings.methods[(i + turn) % settings.methods.size()], spp, repetition,
                        run_seed(spp, repetition)});
      ++turn;
    }
  return runs;
}

RenderOptions run_options(const ChartSettings& settings, const PlannedRun& run) {
  RenderOptions options;
  options.width = settings.width;
  options.height = settings.height;
  options.spp = run.spp;
  options.reuse = kReuse;
  options.shade = {run.method, settings.max_depth, settings.line_rays};
  options.sampler = settings.sampler;
  options.seed = run.seed;
  options.threads = settings.threads;
  return options;
}

std::string depth_text(const std::optional<std::uint32_t>& max_depth) {
  return max_depth ? std::to_string(*max_depth) : "unlimited";
}

std::string chart_title(const ChartSettings& settings) {
  return fmt::format("{}, {}x{}, {}", std::filesystem::path(settings.scene_path).stem().string(),
                     settings.width, settings.height,
                     !settings.max_depth ? "all bounces"
                     : settings.max_depth == 1u
                         ? "direct light only"
                         : fmt::format("at most {} surfaces", *settings.max_depth));
}

ImageMetadata common_metadata(const ChartSettings& settings) {
  ImageMetadata metadata = settings.made_by;
  metadata.emplace_back("scene", settings.scene_path);
  metadata.emplace_back("sceneHash", fmt::format("{:016x}", settings.scene_hash));
  metadata.emplace_back("sampler", std::string(to_string(settings.sampler)));
  metadata.emplace_back("reuse", std::int64_t{kReuse});
  metadata.emplace_back("maxDepth", depth_text(settings.max_depth));
  metadata.emplace_back("threads", std::int64_t{settings.threads});
  return metadata;
}

nlohmann::ordered_json settings_json(const ChartSettings& settings, const std::string& reference,
                                     const std::string& mask) {
  nlohmann::ordered_json j;
  j["scene_hash"] = fmt::format("{:016x}", settings.scene_hash);
  j["width"] = settings.width;
  j["height"] = settings.height;
  j["max_depth"] = depth_text(settings.max_depth);
  j["sampler"] = to_string(settings.sampler);
  j["line_rays"] = settings.line_rays;
  j["threads"] = settings.threads;
  j["reference"] = reference;
  j["mask"] = mask;
  for (const auto& [name, value] : settings.made_by)
    if (name != "argv") j[name] = std::get<std::string>(value);
  return j;
}

void claim_folder(const std::string& folder, const nlohmann::ordered_json& settings) {
  const std::string path = folder + "/settings.json";
  if (!std::filesystem::exists(path)) {
    OutputFile file(path);
    file.write(settings.dump(2) + "\n");
    file.commit();
    return;
  }
  const auto found = nlohmann::ordered_json::parse(read_file(path), nullptr, false);
  if (!found.is_object()) throw InputError(path + ": not a JSON object");
  for (const auto& [key, value] : settings.items()) {
    const auto other = found.value(key, nlohmann::ordered_json());
    if (other != value)
      throw InputError(
          fmt::format("{}: made with {} {}, not {}; choose another --out, or remove "
                      "this one",
                      path, key, other.dump(), value.dump()));
  }
}

}  // namespace raytracing
