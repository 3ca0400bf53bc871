#pragma once

#include <cstdint>

namespace raytracing {

/// 8-bit sRGB code of a linear value (IEC 61966-2-1), rounded to nearest. Values outside [0,1] are
/// clamped; NaN becomes 0.
std::uint8_t srgb8(float linear);

/// The linear value of an sRGB one, both in [0,1] (IEC 61966-2-1).
double srgb_to_linear(double encoded);

}  // namespace raytracing
