#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "raytracing/math/vec.h"

namespace raytracing {

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kInvPi = std::numbers::inv_pi_v<float>;

/// The largest float below 1, the upper limit of all uniform random numbers.
inline constexpr float kOneMinus = 0x1.fffffep-1f;

template <class T>
constexpr T square(T x) {
  return x * x;
}

/// Square root that treats an argument below 0, where rounding has put it, as 0.
inline float safe_sqrt(float x) { return std::sqrt(std::max(x, 0.0f)); }

/// Returns sqrt(d2 + a^2) sqrt(d2 + b^2) + a b without cancellation. `d2` must be >= 0; `roots` is
/// the product of the two square roots.
inline float plus_product_of_roots(float d2, float a, float b, float roots) {
  const float ab = a * b;
  return ab < 0 ? d2 * (d2 + a * a + b * b) / (roots - ab) : roots + ab;
}

/// Returns (cos, sin) of the angle t pi/4 for t in [-1,1], each with an absolute error below 1e-7.
/// Minimax polynomials are faster than the C library and give the same bits on every system. Their
/// own errors are 5e-11 (cosine) and 2e-9 (sine); the rest is rounding.
inline Vec2 circle_eighth(float t) {
  const float z = t * t;
  const float c =
      1.0f + z * (-0.3084251284f + z * (0.0158543233f + z * (-3.2593688e-4f + z * 3.528957e-6f)));
  const float s = 0.7853981256f + z * (-0.0807453617f + z * (2.4898683e-3f + z * -3.5875411e-5f));
  return {c, t * s};
}

/// Returns (cos, sin) of the angle 2 pi u for u in [0,1], each with an absolute error below 1e-7.
inline Vec2 circle(float u) {
  const float quarter = std::floor(4 * u + 0.5f);
  const Vec2 p = circle_eighth(8 * u - 2 * quarter);
  switch (static_cast<int>(quarter) & 3) {
    case 0:
      return p;
    case 1:
      return {-p.y, p.x};
    case 2:
      return {-p.x, -p.y};
    default:
      return {p.y, -p.x};
  }
}

}  // namespace raytracing
