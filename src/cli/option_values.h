#pragma once
// What the values of options may be, and the one line that a wrong one gets.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raytracing {

/// A whole number in decimal digits within [low, high]. Throws UsageError, which names `option`.
std::uint64_t whole_number(std::string_view option, std::string_view text, std::uint64_t low,
                           std::uint64_t high);

/// A decimal number within [low, high]; neither "inf" nor "nan". Throws UsageError.
double real_number(std::string_view option, std::string_view text, double low, double high);

/// Throws UsageError, which names the nearest of `names`, unless `text` is one of them.
void check_name(std::string_view option, const std::string& text,
                const std::vector<std::string>& names);

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& names);

/// The text with line breaks instead of spaces, so that no line is longer than `width` bytes where
/// words allow it.
std::string wrapped(std::string text, std::size_t width);

}  // namespace raytracing
