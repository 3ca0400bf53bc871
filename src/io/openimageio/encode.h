#pragma once

#include <string>
#include <vector>

#include "raytracing/io/image.h"

namespace raytracing::openimageio {

/// See ImageLibrary::endings.
std::vector<std::string> endings();

/// See ImageLibrary::encode.
std::string encode(const ImageData& image, const std::string& ending, bool floats);

}  // namespace raytracing::openimageio
