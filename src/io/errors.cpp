#include "raytracing/io/errors.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace raytracing {
namespace {

// Leaves out the middle of a long text: a message may quote a whole file or a long file name.
std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 1000, kBegin = 600, kEnd = 300;
  if (text.size() <= kLongest) return text;
  return text.substr(0, kBegin) + " ... " + text.substr(text.size() - kEnd);
}

std::string with_location(const TextLocation& where, const std::string& message) {
  const std::string place = to_string(where);
  return one_line(place.empty() ? shortened(message) : place + ": " + shortened(message));
}

// Returns Levenshtein's distance. row[j] is the distance between the prefix of a and j bytes of b.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string to_string(const TextLocation& where) {
  std::string text = where.file;
  for (const long number : {where.line, where.column}) {
    if (number <= 0) break;
    if (!text.empty()) text += ':';
    text += std::to_string(number);
  }
  return text;
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

std::string quoted(std::string_view bytes) {
  constexpr std::size_t kLongest = 40;
  constexpr char kHex[] = "0123456789abcdef";
  std::string text = "'";
  for (const char c : bytes.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f)
      text += c;
    else
      text += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
  }
  return text + (bytes.size() > kLongest ? "...'" : "'");
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](const std::string& a, const std::string& b) {
                             return edit_distance(name, a) < edit_distance(name, b);
                           });
}

InputError::InputError(const TextLocation& where, const std::string& message)
    : std::runtime_error(with_location(where, message)) {}

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
