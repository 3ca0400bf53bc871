#pragma once

#include <string>

#include "raytracing/io/image.h"

namespace raytracing::openimageio {

/// See ImageLibrary::decode.
ImageData decode(const std::string& bytes, const std::string& layer);

}  // namespace raytracing::openimageio
