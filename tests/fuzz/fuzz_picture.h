#pragma once

#include "fuzz.h"
#include "raytracing/io/image.h"

namespace raytracing::fuzz {

/// Decodes the bytes: the image has the size that it states, with R, G and B first, or there is a
/// one-line error.
inline void read_picture(const std::string& bytes) {
  try {
    const ImageData image = decode_image(bytes, "x.picture");
    require(image.width >= 1 && image.height >= 1 && image.channels.size() >= 3, "a picture");
    require(image.channels[0] == "R" && image.channels[1] == "G" && image.channels[2] == "B",
            "R, G and B first");
    require(image.values.size() == image.channels.size() * static_cast<std::size_t>(image.width) *
                                       static_cast<std::size_t>(image.height),
            "a value for each pixel");
  } catch (const InputError& error) {
    check_message(error.what(), "x.picture", false);
  }
}

}  // namespace raytracing::fuzz
