#include "raytracing/study/chart/settings.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"

namespace raytracing {
namespace {

constexpr int kReuse = 1;  // shared paths would hide differences between the methods

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
  options.path = {run.method, settings.max_depth, settings.line_rays};
  options.sampler = settings.sampler;
  options.seed = run.seed;
  options.threads = settings.threads;
  return options;
}

std::string chart_title(const ChartSettings& settings) {
  return fmt::format("{}, {}x{}, {}", std::filesystem::path(settings.scene_path).stem().string(),
                     settings.width, settings.height,
                     !settings.max_depth ? "all bounces"
                     : settings.max_depth == 1u
                         ? "direct light only"
                         : fmt::format("at most {} surfaces", *settings.max_depth));
}

RunFacts planned_facts(const ChartSettings& settings, const PlannedRun& run) {
  RunFacts facts = settings.made_by;
  facts.scene = settings.scene_path;
  facts.scene_hash = hash_text(settings.scene_hash);
  add_options(facts, run_options(settings, run));
  return facts;
}

RunFacts common_facts(const ChartSettings& settings) {
  RunFacts facts = planned_facts(settings, {settings.methods.front(), 0, 0, 0});
  for (const FactField& field : fact_fields())
    if (field.scope == FactScope::run)
      std::visit([&facts](auto member) { (facts.*member).reset(); }, field.member);
  return facts;
}

nlohmann::ordered_json settings_json(const ChartSettings& settings, const std::string& reference,
                                     const std::string& mask) {
  nlohmann::ordered_json j = to_json(common_facts(settings), FactScope::setup);
  j["reference"] = reference;
  j["mask"] = mask;
  return j;
}

void claim_folder(const std::string& folder, const nlohmann::ordered_json& settings) {
  const std::string path = folder + "/settings.json";
  if (!std::filesystem::exists(path)) {
    write_file(path, settings.dump(2) + "\n");
    return;
  }
  auto found = nlohmann::ordered_json::parse(read_file(path), nullptr, false);
  if (!found.is_object()) throw InputError(path + ": not a JSON object");
  found.update(to_json(facts_from_json(found), FactScope::setup));
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
