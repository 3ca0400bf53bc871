#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/io/errors.h"

namespace raytracing {

/// Counts, by kind, what loading changed or left out, so that nothing is lost silently.
class LoadReport {
 public:
  enum class Severity {
    repaired,  ///< read as something other than written; an error under --strict
    dropped,   ///< a record that could not contribute was left out; an error under --strict
    ignored,   ///< valid but without use here (lines, texture coordinates, unknown keywords)
    warning,   ///< read as written, but probably not what was meant
  };
  struct Entry {
    Severity severity;
    std::string kind;    ///< for example "face with a repeated corner"
    TextLocation first;  ///< the location of the first event
    std::uint64_t count;
    std::string name;  ///< the name of the first object concerned; "" where the kind says all
  };

  /// Counts an event of this kind; the first location and name are kept.
  void add(Severity severity, std::string_view kind, const TextLocation& where,
           const std::string& name = "");
  /// The same for files with millions of events: only the first one copies the file's name.
  void add(Severity severity, std::string_view kind, const std::string& file, TextPlace place);
  /// Counts an ignored record as "<kind> '<keyword>'". Once there are `most` keywords of this kind,
  /// further ones count together as "other <kind>", so that garbage does not fill the report.
  void add_keyword(const std::string& kind, std::string_view keyword, const std::string& file,
                   TextPlace place, int most);

  const std::vector<Entry>& entries() const { return entries_; }  ///< in order of first appearance
  std::uint64_t count(Severity severity) const;

 private:
  bool count_again(Severity severity, std::string_view kind);

  std::vector<Entry> entries_;
};

/// "repaired", "dropped", "ignored" or "warning".
const char* to_string(LoadReport::Severity severity);

}  // namespace raytracing
