#pragma once

#include <string>
#include <utility>
#include <vector>

#include "raytracing/study/report.h"
#include "raytracing/study/stress_run.h"

namespace raytracing {

/// What is wrong and where, one line for each method with something to tell.
std::vector<std::string> stress_verdicts(const StressResult& result);

/// What stress.html shows; with the heat maps of `folder` where they were drawn.
Report stress_report(const StressResult& result, const std::string& folder, bool has_pictures,
                     std::vector<std::pair<std::string, std::string>> facts);

}  // namespace raytracing
