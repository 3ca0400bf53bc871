#include "raytracing/io/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace raytracing {
namespace {

// The linear value at which each code from 1 to 255 begins: the sRGB decoding of code - 1/2.
std::array<double, 255> make_code_thresholds() {
  std::array<double, 255> thresholds{};
  for (std::size_t i = 0; i < thresholds.size(); ++i)
    thresholds[i] = srgb_to_linear((static_cast<double>(i) + 0.5) / 255);
  return thresholds;
}

}  // namespace

double srgb_to_linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::uint8_t srgb8(float linear) {
  static const std::array<double, 255> thresholds = make_code_thresholds();
  if (!(linear > 0)) return 0;  // catches NaN, too
  const auto above = std::upper_bound(thresholds.begin(), thresholds.end(), linear);
  return static_cast<std::uint8_t>(above - thresholds.begin());
}

}  // namespace raytracing
