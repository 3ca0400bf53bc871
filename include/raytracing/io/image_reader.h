#pragma once

#include <string>

#include "raytracing/io/image_file.h"

namespace raytracing {

/// Reads an EXR or a PNG picture, told apart by their first bytes. The channels begin with R, G, B.
/// - EXR: all channels of the (first) part's data window, half, float and uint alike, as floats;
///   attributes that are text or a number go to `metadata`. Deep and subsampled ones are refused.
/// - PNG, 8 or 16 bit, grey or colour, decoded to linear by IEC 61966-2-1; text chunks go to
///   `metadata`. Grey becomes three equal channels. A
///   gamma other than sRGB's is refused, and so is transparency: what lies behind is not known.
/// At most 65536 pixels a side and 2^28 values. Throws InputError, "file: reason".
ImageData read_image(const std::string& path);

/// The same for a file's bytes; `file` is used in messages only.
ImageData decode_image(const std::string& bytes, const std::string& file);

}  // namespace raytracing
