#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "raytracing/render/provenance.h"
#include "raytracing/render/render.h"

namespace raytracing {

/// The settings of a chart.
struct ChartSettings {
  std::string folder;
  std::string scene_path;
  std::uint64_t scene_hash = 0;
  int width = 0, height = 0;
  std::optional<std::uint32_t> max_depth;  ///< empty = unlimited
  SamplerKind sampler = SamplerKind::sobol;
  int line_rays = 4;
  int threads = 1;
  std::vector<const DirectMethod*> methods;
  std::vector<std::uint64_t> spp;  ///< rising
  std::uint64_t seeds = 8;         ///< runs of each method at each spp
  RunFacts made_by;                ///< facts about program, machine and command line
};

/// One rendering of the chart.
struct PlannedRun {
  const DirectMethod* method;
  std::uint64_t spp;
  std::uint64_t repetition;  ///< 0 .. seeds - 1
  std::uint64_t seed;        ///< run_seed(spp, repetition)
};

/// The seed of a run. It differs for each spp and repetition, so that no two points of a curve
/// share samples, and is the same for all methods. It is below 2^63, where the seeds of references
/// begin.
std::uint64_t run_seed(std::uint64_t spp, std::uint64_t repetition);
inline constexpr std::uint64_t kFirstReferenceSeed = std::uint64_t{1} << 63;

/// All runs in the order of rendering: repetition by repetition, each from few to many samples per
/// pixel, with the methods in turns and another one first each time, so that a machine that becomes
/// slower or faster favours none.
std::vector<PlannedRun> plan_runs(const ChartSettings& settings);

RenderOptions run_options(const ChartSettings& settings, const PlannedRun& run);

/// The title of a chart: "cornell, 256x256, direct light only".
std::string chart_title(const ChartSettings& settings);

/// The facts of a run that are known before it is rendered.
RunFacts planned_facts(const ChartSettings& settings, const PlannedRun& run);
/// The facts that all runs of the chart share.
RunFacts common_facts(const ChartSettings& settings);

/// The settings that all runs of a folder must share. `reference` and `mask` identify those.
nlohmann::ordered_json settings_json(const ChartSettings& settings, const std::string& reference,
                                     const std::string& mask);

/// Writes `settings` to <folder>/settings.json. When the file is there, compares instead; throws
/// InputError, which names the first difference.
void claim_folder(const std::string& folder, const nlohmann::ordered_json& settings);

}  // namespace raytracing
