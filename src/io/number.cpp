#include "number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace raytracing {

ParsedNumber round_slowly(const char* digits, const char* end, bool negative, long exponent) {
  float value = 0;
  const auto [stop, error] = std::from_chars(digits, end, value);
  if (error == std::errc::result_out_of_range || std::isinf(value)) {
    // from_chars does not say at which end the number left the range: find its decimal magnitude.
    const char* const point = std::find_if_not(digits, end, is_digit);
    const char* const first =
        std::find_if(digits, end, [](char c) { return c >= '1' && c <= '9'; });
    const long magnitude = exponent + static_cast<long>(point - first);
    if (magnitude > 0) return {end, 0, NumberStatus::too_large};
    value = 0;
  }
  return {end, negative ? -value : value, NumberStatus::ok};
}

}  // namespace raytracing
