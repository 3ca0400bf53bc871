#pragma once
// Counts what a parser repairs and leaves out. A LoadReport would do, but builds a location with a
// file name for every event, and some files have millions of them.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/io/load_report.h"
#include "text_cursor.h"

namespace raytracing {

class Tally {
 public:
  using Severity = LoadReport::Severity;

  /// Counts one event.
  void note(Severity severity, std::string_view kind, const TextPlace& where);

  /// Counts an ignored record as "<kind> '<keyword>'". After `most` distinct keywords further ones
  /// count together as "other <kind>", so that garbage does not fill the report.
  void note_keyword(std::string_view kind, std::string_view keyword, const TextPlace& where,
                    int most);

  /// Hands everything over, in order of first appearance.
  void flush(const std::string& file, LoadReport& report) const;

 private:
  struct Entry {
    Severity severity;
    std::string kind;
    TextPlace first;
    std::uint64_t count;
  };

  Entry* find(Severity severity, std::string_view kind);

  std::vector<Entry> entries_;
  int distinct_keywords_ = 0;
};

}  // namespace raytracing
