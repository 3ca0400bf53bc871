#pragma once

namespace raytracing {

/// Whether a light is sampled by this solid angle. Below the lower limit, uniform in area is nearly
/// uniform in solid angle, and cheaper. Above the upper one, which a point reaches at some 1e-5
/// sizes from the light, the rounding of the light's plane leaves the angle itself open (2 pi is
/// that of the plane).
constexpr bool is_usable(double solid_angle) { return solid_angle > 3e-3 && solid_angle < 6.2831; }

}  // namespace raytracing
