#pragma once

#include <string>

#include "raytracing/study/chart_summary.h"

namespace raytracing {

/// The points of all methods, one block each for gnuplot's `index`; columns spp, seconds (median,
/// min, max), error (median, min, max). What is not above 0 is written as NaN, the min then as
/// `bottom`: it is off the logarithmic axis.
std::string plot_data(const ChartSummary& summary, double bottom);

/// The lower end of the charts' error axis, a power of ten below all points.
double plot_bottom(const ChartSummary& summary);

/// Commands that draw error_vs_time and error_vs_spp as .svg and .png from chart.dat, for gnuplot 5
/// run in the folder of the chart.
std::string plot_script(const ChartSummary& summary, const std::string& title);

/// Runs gnuplot on <folder>/<script>. False when it is not in PATH. Throws OutputError when it
/// fails.
bool run_gnuplot(const std::string& folder, const std::string& script);

}  // namespace raytracing
