#pragma once
// Mappings from the unit square to distributions on other domains, each with its density.

#include <cmath>

#include "raytracing/math/numeric.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// Maps the square to the unit disk uniformly, by the concentric map of Shirley & Chiu 1997. The
/// density is 1/pi per unit area.
inline Vec2 square_to_disk(const Vec2& u) {
  const float a = 2 * u.x - 1;
  const float b = 2 * u.y - 1;
  const bool wide = std::abs(a) > std::abs(b);
  const float r = wide ? a : b;
  if (r == 0) return {0.0f, 0.0f};
  const Vec2 p = r * circle_eighth((wide ? b : a) / r);
  return wide ? p : Vec2(p.y, p.x);
}

/// Maps the square to unit directions about +z with a density proportional to their cosine.
inline Vec3 square_to_cosine_hemisphere(const Vec2& u) {
  const Vec2 d = square_to_disk(u);
  return {d.x, d.y, safe_sqrt(1 - d.x * d.x - d.y * d.y)};
}
/// The density of square_to_cosine_hemisphere per steradian.
inline float cosine_hemisphere_pdf_w(float cos_theta) { return std::max(cos_theta, 0.0f) * kInvPi; }

/// Returns the barycentric weights of the second and third corner of a triangle for a point uniform
/// on it. The density is 1 / area of the triangle, per unit area.
inline Vec2 square_to_triangle(const Vec2& u) {
  const float root = std::sqrt(u.x);
  return {(1 - u.y) * root, u.y * root};
}

}  // namespace raytracing
