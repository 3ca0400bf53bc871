#pragma once

#include <string>

#include "raytracing/io/image_file.h"

namespace raytracing {

// Both take an image whose values fill its pixels and channels, and throw OutputError.

/// 8-bit sRGB from the channels R, G, B; metadata as text chunks.
std::string encode_png(const ImageData& image);

/// All channels as 32-bit floats, ZIP compressed; metadata as typed attributes.
std::string encode_exr(const ImageData& image);

}  // namespace raytracing
