#pragma once

#include <string>
#include <vector>

#include "raytracing/study/stress_run.h"

namespace raytracing {

/// All cells as a table for other programs: comma-separated, one line a cell.
std::string stress_csv(const StressResult& result);

/// The pictures' names without extension: "stress", the overview, then one for each family.
std::vector<std::string> stress_pictures(const StressResult& result);
/// The same of a run of all cases.
std::vector<std::string> all_stress_pictures();

/// The cells of the heat maps, a block for each case, then one for the overview; for gnuplot's
/// `index`.
std::string stress_plot_data(const StressResult& result);

/// Commands that draw the heat maps as .svg and .png from stress.dat, for gnuplot 5 run in the
/// folder of the result.
std::string stress_plot_script(const StressResult& result);

}  // namespace raytracing
