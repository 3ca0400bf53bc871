#include "raytracing/io/load_report.h"

#include <algorithm>

namespace raytracing {

void LoadReport::add(Severity severity, const std::string& kind, const TextLocation& where,
                     std::uint64_t count, const std::string& name) {
  if (count == 0) return;
  const auto same = [&](const Entry& e) { return e.severity == severity && e.kind == kind; };
  const auto found = std::find_if(entries_.begin(), entries_.end(), same);
  if (found != entries_.end()) {
    found->count += count;
  } else {
    entries_.push_back({severity, kind, where, count, name});
  }
}

std::uint64_t LoadReport::count(Severity severity) const {
  std::uint64_t sum = 0;
  for (const Entry& entry : entries_) {
    if (entry.severity == severity) sum += entry.count;
  }
  return sum;
}

const char* to_string(LoadReport::Severity severity) {
  switch (severity) {
    case LoadReport::Severity::repaired:
      return "repaired";
    case LoadReport::Severity::dropped:
      return "dropped";
    case LoadReport::Severity::ignored:
      return "ignored";
    case LoadReport::Severity::warning:
      return "warning";
  }
  return "unknown";
}

}  // namespace raytracing
