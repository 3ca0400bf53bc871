#pragma once

#include <string>

#include "raytracing/study/metrics/pixels.h"

namespace raytracing {

/// The relative squared errors in false colours: the map "magma" (van der Walt and Smith 2015) on a
/// logarithmic scale, fixed so that error maps can be compared; see error_colours(). Cyan pixels
/// are not finite, grey ones lie outside the mask. The channels are R, G, B, linear. Throws
/// InputError for pictures of different sizes or a mask of another size.
ImageData error_map(const ImageData& test, const ImageData& reference, const PixelMask& mask = {});

/// The error map with a colour bar, its numbers and the formula below. Throws OutputError where the
/// font of the numbers is not installed.
ImageData error_picture(const ImageData& test, const ImageData& reference,
                        const PixelMask& mask = {});

/// The colour scale as text: "black (1e-5 and less) over red to light yellow (1e1 and more)".
std::string error_colours();

}  // namespace raytracing
