#pragma once

#include <string>

#include "raytracing/study/chart/summary.h"

namespace raytracing {

/// The points of all methods, one block each for gnuplot's `index`, with the columns spp, seconds
/// (median, min, max), error (median, min, max). A value that is not above 0 is written as NaN, a
/// minimum as `bottom`: both are off the logarithmic axis.
std::string plot_data(const ChartSummary& summary, double bottom);

/// The lower end of the charts' error axis, a power of ten below all points.
double plot_bottom(const ChartSummary& summary);

/// A script for gnuplot 5.2 or later, to be run in the folder of the chart: draws error_vs_time and
/// error_vs_spp as .svg and .png from chart.dat. The script is the chart's own variables, then
/// chart.gp.
std::string plot_script(const ChartSummary& summary, const std::string& title);

}  // namespace raytracing
