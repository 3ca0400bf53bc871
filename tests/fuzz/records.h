#pragma once
// Counts the records of OBJ and MTL text in the simplest way, to check the reports of the parsers.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "fuzz.h"

namespace raytracing::fuzz {

/// How many records begin with each keyword.
using Records = std::map<std::string, std::uint64_t>;

/// Counts the records of a text. Keywords in `naming` precede a name, in which '#' begins a comment
/// only between blanks.
inline Records count_records(std::string_view text, const std::set<std::string>& naming) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; };
  const auto line_end = [](char c) { return c == '\n' || c == '\r'; };
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  std::string all;  // with a line end at the end, which saves checks for the end of the text
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] != '\n' || i == 0 || text[i - 1] != '\r') all += text[i];
  all += '\n';

  Records counts;
  for (std::size_t at = 0; at < all.size(); ++at) {  // from record to record
    std::string keyword;
    bool in_keyword = true, comment = false;
    for (; at < all.size(); ++at) {
      const char c = all[at];
      if (line_end(c)) break;
      if (comment) continue;
      const bool continued = c == '\\' && line_end(all[at + 1]);
      if (continued && at + 2 < all.size()) ++at;
      if (continued || blank(c)) {
        in_keyword = in_keyword && keyword.empty();
      } else if (in_keyword && (c != '#' || !keyword.empty())) {
        keyword += c;
      } else if (c == '#') {
        const bool name = naming.contains(keyword);
        const char before = at > 0 ? all[at - 1] : '\n', next = all[at + 1];
        comment = !name || ((blank(before) || line_end(before)) && (blank(next) || line_end(next)));
        if (keyword.empty()) comment = true;
      }
    }
    if (!keyword.empty()) ++counts[keyword];
  }
  return counts;
}

/// Requires that the report counts all these records as ignored, as `kind` or as "other <kind>".
inline void check_ignored(const Records& records, const LoadReport& report,
                          const std::string& kind) {
  std::uint64_t sum = 0;
  for (const auto& [keyword, n] : records) sum += n;
  require(sum == count(report, LoadReport::Severity::ignored, kind) +
                     count(report, LoadReport::Severity::ignored, "other " + kind),
          "every other record is counted", kind);
}

}  // namespace raytracing::fuzz
