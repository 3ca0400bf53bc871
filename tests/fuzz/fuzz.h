#pragma once
// Checks that the fuzzers share. A property that does not hold aborts the process, which libFuzzer
// records as a finding with its input.

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "raytracing/io/errors.h"

namespace raytracing::fuzz {

inline void require(bool holds, const char* property, std::string_view text = "") {
  if (holds) return;
  std::fprintf(stderr, "property broken: %s: %.*s\n", property, static_cast<int>(text.size()),
               text.data());
  std::abort();
}

inline bool takes_number(std::string_view& text) {
  std::size_t digits = 0;
  while (digits < text.size() && std::isdigit(static_cast<unsigned char>(text[digits]))) ++digits;
  const bool number = digits > 0 && text[0] != '0' && digits < text.size() && text[digits] == ':';
  if (number) text.remove_prefix(digits + 1);
  return number;
}

/// Requires a short message of one line.
inline void check_one_line(std::string_view what) {
  require(what.size() < 2000, "a message is short", what.substr(0, 200));
  for (const char c : what)
    require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "a message is one line", what);
}

/// Requires also that it begins with "file:" and, if `with_place`, continues with "line:column:".
inline void check_message(std::string_view what, std::string_view file, bool with_place) {
  check_one_line(what);
  require(what.starts_with(file) && what.substr(file.size()).starts_with(":"),
          "a message begins with the file", what);
  if (!with_place) return;
  what.remove_prefix(file.size() + 1);
  require(takes_number(what) && takes_number(what), "a message has line and column", what);
  require(what.size() > 2, "a message says something", what);
}

/// Requires that every entry counts something, has a name of one line and lies within the text.
inline void check_report(const LoadReport& report, std::string_view text) {
  long lines = 1;
  for (const char c : text) lines += c == '\n' || c == '\r';
  for (const LoadReport::Entry& e : report.entries()) {
    require(e.count > 0 && !e.kind.empty(), "an entry counts something", e.kind);
    require(e.first.line >= 1 && e.first.line <= lines && e.first.column >= 1,
            "an entry has a place in the text", e.kind);
    for (const char c : e.kind)
      require(static_cast<unsigned char>(c) >= 0x20, "an entry is one line", e.kind);
  }
}

/// The number of events of this severity and kind.
inline std::uint64_t count(const LoadReport& report, LoadReport::Severity severity,
                           std::string_view kind) {
  std::uint64_t sum = 0;
  for (const LoadReport::Entry& e : report.entries())
    if (e.severity == severity && e.kind.starts_with(kind)) sum += e.count;
  return sum;
}

/// Calls parse(text, report) for the input, and check_error(text, what) for what it throws.
template <class Parse, class CheckError>
int read_text(const std::uint8_t* data, std::size_t size, const Parse& parse,
              const CheckError& check_error) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  LoadReport report;
  try {
    parse(text, report);
  } catch (const InputError& error) {
    check_error(text, error.what());
  }
  return 0;
}

}  // namespace raytracing::fuzz
