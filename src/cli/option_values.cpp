#include "option_values.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "raytracing/io/errors.h"
#include "raytracing/io/nearest_name.h"

namespace raytracing {

std::uint64_t whole_number(std::string_view option, std::string_view text, std::uint64_t low,
                           std::uint64_t high) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool negative = text.size() > 1 && text[0] == '-' &&
                        text.find_first_not_of("0123456789", 1) == std::string_view::npos;
  if (!negative && (stop != end || error == std::errc::invalid_argument))
    throw UsageError(fmt::format("{}: '{}' is not a whole number", option, text));
  if (negative || error != std::errc() || value < low || value > high)
    throw UsageError(fmt::format("{}: {} is not in {} .. {}", option, text, low, high));
  return value;
}

double real_number(std::string_view option, std::string_view text, double low, double high) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument ||
      text.find_first_not_of("0123456789+-.eE") != std::string_view::npos)
    throw UsageError(fmt::format("{}: '{}' is not a number", option, text));
  if (error != std::errc() || value < low || value > high)
    throw UsageError(fmt::format("{}: {} is not in {} .. {}", option, text, low, high));
  return value;
}

void check_name(std::string_view option, const std::string& text,
                const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (name == text) return;
  throw UsageError(fmt::format("{}: '{}' is not {}; the nearest is {}", option, text,
                               alternatives(names), nearest_name(text, names)));
}

std::string alternatives(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

std::string wrapped(std::string text, std::size_t width) {
  std::size_t line = 0, last_space = std::string::npos;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ') last_space = i;
    if (i - line < width || last_space == std::string::npos || last_space < line) continue;
    text[last_space] = '\n';
    line = last_space + 1;
  }
  return text;
}

}  // namespace raytracing
