#pragma once

#include <string>
#include <vector>

#include "raytracing/io/image.h"

namespace raytracing {

/// An image that is compared, and the path by which messages name it.
struct NamedImage {
  const std::string& path;
  const ImageData& image;
};

/// Returns what a user must know of a comparison of these pixels of two images, one line each: what
/// their headers state against it, and what reading them changed or chose.
std::vector<std::string> comparison_notes(const NamedImage& test, const NamedImage& reference,
                                          const PixelWindow& window);

}  // namespace raytracing
