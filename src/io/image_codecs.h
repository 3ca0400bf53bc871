#pragma once
// The codecs behind image.h. Encoders take an image whose values fill its pixels and channels and
// throw OutputError; decoders take the bytes of a file and throw InputError without its name.

#include <cstdint>
#include <string>

#include "raytracing/io/image.h"

namespace raytracing {

std::string encode_png(const ImageData& image);
ImageData decode_png(const std::string& bytes);

std::string encode_exr(const ImageData& image);
ImageData decode_exr(const std::string& bytes);

/// Throws InputError for more pixels or values than are read. Must be called before any allocation
/// that depends on the size that a file claims.
void check_image_size(std::int64_t width, std::int64_t height, std::size_t channels);

/// Throws InputError unless the sizes that the header of this EXR file states are those of what it
/// holds. OpenEXR allocates what an attribute claims before it finds out that the file is shorter,
/// and continues into the next attribute when one claims too little.
void check_exr_header_sizes(const std::string& bytes);

}  // namespace raytracing
