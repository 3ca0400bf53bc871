#pragma once

#include "raytracing/geometry/sphere.h"
#include "raytracing/math/interval_set.h"

namespace raytracing {

/// Takes from `visible` the part of the segment from a to b that the sphere's surface hides from p.
void subtract_sphere(const Sphere& sphere, const Vec3& p, const Vec3& a, const Vec3& b,
                     IntervalSet& visible);

}  // namespace raytracing
