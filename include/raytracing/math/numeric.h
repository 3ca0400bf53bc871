#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracing {

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kInvPi = std::numbers::inv_pi_v<float>;

/// The largest float below 1; the upper end of every uniform number here.
inline constexpr float kOneMinus = 0x1.fffffep-1f;

template <class T>
constexpr T square(T x) {
  return x * x;
}

/// Square root of a number that rounding may have pushed below 0.
inline float safe_sqrt(float x) { return std::sqrt(std::max(x, 0.0f)); }

/// sqrt(d2 + a^2) sqrt(d2 + b^2) + a b for d2 >= 0, given the product of the two roots, in the form
/// that does not cancel.
inline float plus_product_of_roots(float d2, float a, float b, float roots) {
  const float ab = a * b;
  return ab < 0 ? d2 * (d2 + a * a + b * b) / (roots - ab) : roots + ab;
}

/// Arcus cosine of a number that rounding may have pushed out of [-1,1].
inline float safe_acos(float x) { return std::acos(std::clamp(x, -1.0f, 1.0f)); }

}  // namespace raytracing
