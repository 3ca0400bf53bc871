#pragma once

namespace raytracing {

/// src/study/report.html with its style and script inside.
extern const char* const kReportTemplate;

}  // namespace raytracing
