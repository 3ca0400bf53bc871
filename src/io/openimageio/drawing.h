#pragma once

#include <vector>

#include "raytracing/io/image_library.h"

namespace raytracing::openimageio {

/// See ImageLibrary::magma.
std::vector<float> magma(const std::vector<float>& values);

/// See ImageLibrary::draw_labels.
void draw_labels(ImageData& image, const std::vector<TextLabel>& labels);

}  // namespace raytracing::openimageio
