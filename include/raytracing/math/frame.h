#pragma once

#include <cmath>

#include "raytracing/math/vec.h"

namespace raytracing {

/// Right-handed orthonormal frame; z is the normal.
struct Frame {
  Vec3 x, y, z;

  /// A frame around the unit vector `n`, without a branch (Duff et al. 2017, listing 3).
  static Frame around(const Vec3& n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    return {
        {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
  }

  Vec3 to_local(const Vec3& w) const { return {dot(w, x), dot(w, y), dot(w, z)}; }
  Vec3 to_world(const Vec3& w) const { return w.x * x + w.y * y + w.z * z; }
};

}  // namespace raytracing
