#pragma once

#include <optional>
#include <string>

#include "raytracing/io/image.h"

namespace raytracing {

/// The whole picture that an image is or is a part of; x and y as in ImageData::whole.
PixelWindow whole_of(const ImageData& image);

/// The pixels of an image in the whole picture that it is a part of (see ImageData::whole); x and y
/// are those of its first pixel.
PixelWindow window_of(const ImageData& image);

/// Returns the pixels of the image in that window, which must lie in its own.
ImageData cropped(const ImageData& image, const PixelWindow& window);

/// Returns the pixels that both images have. Empty where there are none, and where the whole
/// pictures differ in size.
std::optional<PixelWindow> common_window(const ImageData& a, const ImageData& b);

/// Returns the size of the image for messages, and its place where it is a part: "12x8 pixels at
/// 3,2 of 18x14".
std::string pixels_text(const ImageData& image);

}  // namespace raytracing
