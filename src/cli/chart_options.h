#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"
#include "progress_display.h"
#include "raytracing/integrator/direct_method.h"

namespace raytracing {

/// What the command line of `chart` asks for.
struct ChartArguments {
  std::string scene;
  std::string folder;
  std::vector<const DirectMethod*> methods;  ///< default: all
  std::vector<std::uint64_t> spp{1, 2, 4, 8, 16, 32, 64};
  std::uint64_t seeds = 8;
  std::optional<std::uint32_t> max_depth;
  std::string reference = "auto";  ///< or a file
  double reference_time = 60;      ///< seconds
  std::string mask;                ///< "" = none
  std::optional<int> width, height;
  int line_rays = 4;
  SamplerKind sampler = SamplerKind::sobol;
  int threads = 1;
  ProgressStyle progress = ProgressStyle::automatic;
  bool quiet = false;
  std::optional<std::string> text;  ///< that was asked for instead of a chart: the help
};

/// Throws UsageError.
ChartArguments parse_chart_arguments(const Arguments& arguments);

}  // namespace raytracing
