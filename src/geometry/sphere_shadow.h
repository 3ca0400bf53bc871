#pragma once

#include "raytracing/geometry/sphere.h"
#include "raytracing/math/interval_set.h"

namespace raytracing {

/// Takes from `visible` the part of the segment a + t d, t in [0,1], that the sphere's surface
/// hides from p.
void subtract_sphere(const Sphere& sphere, const Vec3& p, const Vec3& a, const Vec3& d,
                     IntervalSet& visible);

}  // namespace raytracing
