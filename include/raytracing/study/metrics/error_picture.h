#pragma once

#include <string>

#include "raytracing/study/metrics/error_metrics.h"

namespace raytracing {

/// The relative squared errors in false colours: matplotlib's "magma" on a logarithmic scale, fixed
/// so that error maps can be compared; see error_colours(). Cyan pixels are not finite, grey ones
/// lie outside the mask. The channels are R, G, B, linear. Throws InputError for pictures of
/// different sizes or a mask of another size.
ImageData error_map(const ImageData& test, const ImageData& reference, const PixelMask& mask = {});

/// The error map with a colour bar, its numbers and the formula below.
ImageData error_picture(const ImageData& test, const ImageData& reference,
                        const PixelMask& mask = {});

/// The colour scale as text: "black (1e-5 and less) over red to light yellow (1e1 and more)".
std::string error_colours();

/// The colour at t in [0,1] of the map, as 8-bit sRGB codes; t beyond goes to the nearest end.
Rgb magma(double t);

}  // namespace raytracing
