#pragma once

#include <string>
#include <utility>
#include <vector>

#include "raytracing/study/page/report_page.h"
#include "raytracing/study/stress/result.h"

namespace raytracing {

/// The contents of stress.html, with the heat maps of `folder` where they were drawn.
Report stress_report(const StressResult& result, const std::string& folder, bool has_pictures,
                     std::vector<std::pair<std::string, std::string>> facts);

}  // namespace raytracing
