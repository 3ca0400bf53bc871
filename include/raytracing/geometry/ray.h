#pragma once

#include "raytracing/math/vec.h"

namespace raytracing {

/// Half line; `direction` need not be of unit length.
struct Ray {
  Vec3 origin;
  Vec3 direction;
};

/// How far a point computed on a surface, and Embree's idea of that surface, may lie apart, when no
/// coordinate of the surface exceeds `max_coordinate` in size. A few dozen float spacings: it
/// follows the numbers' own rounding, not the size of the scene's details.
inline float position_error(float max_coordinate) { return 32 * 0x1p-24f * max_coordinate; }

/// Moves the surface point `p` off its surface by `error`, to the side of the unit normal `n`.
inline Vec3 offset_point(const Vec3& p, const Vec3& n, float error) { return p + error * n; }

}  // namespace raytracing
