#pragma once

#include <string>
#include <utility>
#include <vector>

#include "raytracing/study/chart/summary.h"
#include "raytracing/study/page/report_page.h"

namespace raytracing {

/// The contents of a chart's report.html: for each method the picture of the first seed at about
/// the longest time at which all methods were measured, the reference, the charts in the folder
/// (when they were drawn) and tables. `facts` come first in the list of facts.
Report chart_report(const ChartSettings& settings, const ChartSummary& summary, const RunLog& log,
                    const GroundTruth& truth, bool has_charts,
                    std::vector<std::pair<std::string, std::string>> facts);

}  // namespace raytracing
