#pragma once

#include "raytracing/study/chart_summary.h"
#include "raytracing/study/report.h"

namespace raytracing {

/// Equal time, equal error, fits and bias, and all points, as tables for people.
std::vector<ReportTable> chart_tables(const ChartSummary& summary);

}  // namespace raytracing
