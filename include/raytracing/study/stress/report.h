#pragma once

#include <string>
#include <utility>
#include <vector>

#include "raytracing/study/page/report_page.h"
#include "raytracing/study/stress/result.h"

namespace raytracing {

/// The names of the pictures without extension: "stress", the overview, then one for each family.
std::vector<std::string> stress_pictures(const StressResult& result);
/// The names of the pictures of a run of all cases.
std::vector<std::string> all_stress_pictures();

/// The cells of the heat maps for gnuplot's `index`: a block for each case, then the overview.
std::string stress_plot_data(const StressResult& result);

/// A script for gnuplot 5.2 or later, to be run in the folder of the result: draws the heat maps as
/// .svg and .png from stress.dat. The script is the run's own variables, then stress.gp.
std::string stress_plot_script(const StressResult& result);

/// The contents of stress.html, with the heat maps of `folder` where they were drawn.
Report stress_report(const StressResult& result, const std::string& folder, bool has_pictures,
                     std::vector<std::pair<std::string, std::string>> facts);

}  // namespace raytracing
