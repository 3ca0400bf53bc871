#pragma once

#include <cstdint>
#include <string>

#include "raytracing/io/image_file.h"

namespace raytracing {

// Both take a complete file's bytes and throw InputError without the file's name.

ImageData decode_png(const std::string& bytes);
ImageData decode_exr(const std::string& bytes);

/// Throws InputError for more pixels or values than are read. To be called before any allocation
/// that depends on the size that a file claims.
void check_image_size(std::int64_t width, std::int64_t height, std::size_t channels);

}  // namespace raytracing
