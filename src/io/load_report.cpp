#include "raytracing/io/load_report.h"

#include <algorithm>

namespace raytracing {

void LoadReport::add(Severity severity, std::string_view kind, const TextLocation& where,
                     const std::string& name) {
  if (!count_again(severity, kind))
    entries_.push_back({severity, std::string(kind), where, 1, name});
}

void LoadReport::add(Severity severity, std::string_view kind, const std::string& file,
                     TextPlace place) {
  if (!count_again(severity, kind))
    entries_.push_back({severity, std::string(kind), {file, place.line, place.column}, 1, ""});
}

void LoadReport::add_keyword(const std::string& kind, std::string_view keyword,
                             const std::string& file, TextPlace place, int most) {
  const std::string named = kind + ' ' + quoted(keyword);
  if (count_again(Severity::ignored, named)) return;
  const auto keywords = std::count_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.kind.starts_with(kind + " '");
  });
  add(Severity::ignored, keywords < most ? named : "other " + kind, file, place);
}

// True if there is an entry of this kind, which then counts one more event.
bool LoadReport::count_again(Severity severity, std::string_view kind) {
  for (Entry& entry : entries_)
    if (entry.severity == severity && entry.kind == kind) {
      ++entry.count;
      return true;
    }
  return false;
}

std::uint64_t LoadReport::count(Severity severity) const {
  std::uint64_t sum = 0;
  for (const Entry& entry : entries_)
    if (entry.severity == severity) sum += entry.count;
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
