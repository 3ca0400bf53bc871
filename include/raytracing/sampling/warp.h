#pragma once
// Warps of the unit square, each beside its density. `pdf_w` is per steradian, `pdf_a` per area.

#include <cmath>

#include "raytracing/math/circle.h"
#include "raytracing/math/numeric.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// Uniform on the unit disk, keeping neighbours together (Shirley & Chiu 1997). Density 1/pi.
inline Vec2 square_to_disk(const Vec2& u) {
  const float a = 2 * u.x - 1;
  const float b = 2 * u.y - 1;
  const bool wide = std::abs(a) > std::abs(b);
  const float r = wide ? a : b;
  if (r == 0) return {0.0f, 0.0f};
  const Vec2 p = r * circle_eighth((wide ? b : a) / r);
  return wide ? p : Vec2(p.y, p.x);
}

/// Cosine-distributed direction about +z.
inline Vec3 square_to_cosine_hemisphere(const Vec2& u) {
  const Vec2 d = square_to_disk(u);
  return {d.x, d.y, safe_sqrt(1 - d.x * d.x - d.y * d.y)};
}
inline float cosine_hemisphere_pdf_w(float cos_theta) { return std::max(cos_theta, 0.0f) * kInvPi; }

/// Uniform barycentric weights of a triangle's second and third corner. Density 1/area.
inline Vec2 square_to_triangle(const Vec2& u) {
  const float root = std::sqrt(u.x);
  return {(1 - u.y) * root, u.y * root};
}

/// Probability weight of the balance heuristic (Veach & Guibas 1995, eq. 14) for one sample each.
inline float balance_heuristic(float pdf, float other_pdf) { return pdf / (pdf + other_pdf); }

}  // namespace raytracing
