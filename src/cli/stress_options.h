#pragma once

#include <optional>
#include <string>

#include "commands.h"
#include "progress_display.h"
#include "raytracing/study/stress_run.h"

namespace raytracing {

/// What the command line of `stress` asks for.
struct StressArguments {
  StressPlan plan;  ///< default: all cases, all methods
  std::string folder;
  ProgressStyle progress = ProgressStyle::automatic;
  bool quiet = false;
  std::optional<std::string> text;  ///< that was asked for instead: the help
};

/// Throws UsageError.
StressArguments parse_stress_arguments(const Arguments& arguments);

}  // namespace raytracing
