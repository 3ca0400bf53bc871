#pragma once

namespace raytracing {

/// Whether float arithmetic can sample by this solid angle. Below the lower limit, rounding may
/// exceed 1e-4 of it, and uniform in area is nearly uniform in solid angle anyway. Above the upper
/// one (2 pi is the plane of the light itself) the warp's inverse loses its digits.
constexpr bool is_usable(float solid_angle) { return solid_angle > 3e-3f && solid_angle < 6.2f; }

}  // namespace raytracing
