#pragma once

#include "raytracing/study/metrics/error_metrics.h"

namespace raytracing {

/// The ends of the colour bar, as powers of 10. Fixed, so that error pictures can be compared.
struct ErrorScale {
  int low = -5, high = 1;
};

/// The relative squared errors in false colours on a logarithmic scale: matplotlib's "magma", from
/// black (10^low and less) over red to light yellow (10^high and more). Cyan: not finite; grey:
/// outside the mask. Below the picture, a colour bar with numbers and the formula. R, G, B, linear.
ImageData error_picture(const ImageData& test, const ImageData& reference,
                        const PixelMask& mask = {}, const ErrorScale& scale = {});

/// The colour at t in [0,1] of the map, as 8-bit sRGB codes; t beyond goes to the nearest end.
Rgb magma(double t);

}  // namespace raytracing
