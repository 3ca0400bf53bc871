#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

// What a file holds, or a file's name, may be long: the middle is left out.
std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 1000, kBegin = 600, kEnd = 300;
  if (text.size() <= kLongest) return text;
  return text.substr(0, kBegin) + " ... " + text.substr(text.size() - kEnd);
}

std::string with_place(const TextLocation& where, const std::string& message) {
  const std::string place = to_string(where);
  return one_line(place.empty() ? shortened(message) : place + ": " + shortened(message));
}

}  // namespace

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return text;
}

std::string to_string(const TextLocation& where) {
  std::string text = where.file;
  for (const long number : {where.line, where.column}) {
    if (number <= 0) break;
    if (!text.empty()) text += ':';
    text += std::to_string(number);
  }
  return text;
}

InputError::InputError(const TextLocation& where, const std::string& message)
    : std::runtime_error(with_place(where, message)) {}

}  // namespace raytracing
