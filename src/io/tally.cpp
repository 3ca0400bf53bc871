#include "tally.h"

namespace raytracing {

Tally::Entry* Tally::find(Severity severity, std::string_view kind) {
  for (Entry& entry : entries_) {
    if (entry.severity == severity && entry.kind == kind) return &entry;
  }
  return nullptr;
}

void Tally::note(Severity severity, std::string_view kind, const TextPlace& where) {
  if (Entry* entry = find(severity, kind)) {
    ++entry->count;
  } else {
    entries_.push_back({severity, std::string(kind), where, 1});
  }
}

void Tally::note_keyword(std::string_view kind, std::string_view keyword, const TextPlace& where,
                         int most) {
  const std::string named = std::string(kind) + ' ' + quoted(keyword);
  if (Entry* entry = find(Severity::ignored, named)) {
    ++entry->count;
  } else if (distinct_keywords_ < most) {
    ++distinct_keywords_;
    entries_.push_back({Severity::ignored, named, where, 1});
  } else {
    note(Severity::ignored, "other " + std::string(kind), where);
  }
}

void Tally::flush(const std::string& file, LoadReport& report) const {
  for (const Entry& entry : entries_) {
    report.add(entry.severity, entry.kind, {file, entry.first.line, entry.first.column},
               entry.count);
  }
}

}  // namespace raytracing
