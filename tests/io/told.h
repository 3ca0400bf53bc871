#pragma once

#include <string>

#include "raytracing/io/errors.h"

namespace raytracing {

/// The contents of a report in one line: "severity kind xcount at line:column; ...".
inline std::string told(const LoadReport& report) {
  std::string text;
  for (const LoadReport::Entry& e : report.entries()) {
    if (!text.empty()) text += "; ";
    text += to_string(e.severity) + (" " + e.kind) + " x" + std::to_string(e.count) + " at " +
            std::to_string(e.first.line) + ":" + std::to_string(e.first.column);
  }
  return text;
}

}  // namespace raytracing
