#pragma once

#include <vector>

#include "raytracing/study/metrics/pixels.h"

namespace raytracing {

/// The resolution for a viewer at 0.7 m from a screen of 3840 pixels on 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 67;

/// How different two pictures look when one flips between them: FLIP for low dynamic range
/// (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference
/// Evaluator for Alternating Images", 2020). One value in [0,1] per pixel, top row first. Both
/// pictures are linear, shown with values beyond [0,1] cut off (NaN as 0). Throws InputError for
/// pictures of different sizes or without R, G, B.
std::vector<float> flip_map(const ImageData& test, const ImageData& reference,
                            double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace raytracing
