#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "raytracing/io/image_file.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// Three channels of a picture that must outlive the view, by pixel index (top row first).
class RgbView {
 public:
  /// The channels <prefix>R, <prefix>G, <prefix>B. Throws InputError where one is missing.
  explicit RgbView(const ImageData& image, const std::string& prefix = "");

  /// Whether the picture has these channels.
  static bool has(const ImageData& image, const std::string& prefix);

  std::size_t pixels() const { return pixels_; }
  DVec3 operator[](std::size_t pixel) const {
    const float* values = values_ + pixel * stride_;
    return {values[offsets_[0]], values[offsets_[1]], values[offsets_[2]]};
  }

 private:
  const float* values_;
  std::size_t stride_;
  std::size_t pixels_;
  std::array<std::size_t, 3> offsets_;
};

}  // namespace raytracing
