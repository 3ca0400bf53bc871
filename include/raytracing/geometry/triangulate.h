#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raytracing/math/vec.h"

namespace raytracing {

/// Area-weighted normal of a closed polygon (Newell's method); its length is twice the area of a
/// planar polygon. Computed in double relative to the first corner.
DVec3 newell_normal(std::span<const Vec3> corners);

/// True when the polygon is convex as seen along its Newell normal (collinear corners allowed).
bool is_convex(std::span<const Vec3> corners);

/// Cuts a simple polygon, convex or concave, into corner_count - 2 triangles by ear clipping.
/// Returned indices run into `corners` and keep the polygon's orientation. The signed areas of the
/// triangles along the Newell normal sum to the polygon's. A polygon that is not simple is cut
/// too, into as many triangles, but those may then overlap.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace raytracing
