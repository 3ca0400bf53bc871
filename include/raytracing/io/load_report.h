#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raytracing/io/errors.h"

namespace raytracing {

/// What loading changed or left out, counted by kind, so that nothing is lost silently.
class LoadReport {
 public:
  enum class Severity {
    repaired,  ///< read as something other than what stood there; an error under --strict
    dropped,   ///< a record that could not contribute was left out; an error under --strict
    ignored,   ///< valid, but of no use here (lines, texture coordinates, unknown keywords)
    warning,   ///< read as it stands, but probably not what was meant
  };
  struct Entry {
    Severity severity;
    std::string kind;    ///< for example "face with a repeated corner"
    TextLocation first;  ///< where it happened first
    std::uint64_t count;
    std::string name;  ///< of what it happened to first; "" where the kind says all
  };

  /// Counts events of this kind; the first place and name are kept.
  void add(Severity severity, const std::string& kind, const TextLocation& where,
           std::uint64_t count = 1, const std::string& name = "");

  const std::vector<Entry>& entries() const { return entries_; }  ///< in order of first appearance
  std::uint64_t count(Severity severity) const;

 private:
  std::vector<Entry> entries_;
};

/// "repaired", "dropped", "ignored" or "warning".
const char* to_string(LoadReport::Severity severity);

}  // namespace raytracing
