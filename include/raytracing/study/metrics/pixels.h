#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "raytracing/io/image.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// Three channels of a picture by pixel index, top row first. The picture must outlive the view.
class RgbView {
 public:
  /// Views the channels <prefix>R, <prefix>G, <prefix>B. Throws InputError where one is missing.
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

/// One byte per pixel, non-zero where the pixel counts. An empty mask counts all pixels.
using PixelMask = std::vector<std::uint8_t>;

/// Whether the mask counts this pixel.
inline bool counts(const PixelMask& mask, std::size_t pixel) {
  return mask.empty() || mask[pixel] != 0;
}

/// A mask from a picture: a pixel counts where the linear mean of R, G, B is at least 1/2.
PixelMask to_mask(const ImageData& mask);

/// Reads the mask for those pixels of a picture of this size; the path "" gives the empty mask.
/// Appends what reading changed or chose to `notes`, as messages of one line. Throws InputError,
/// also for a mask without a white pixel.
PixelMask read_mask(const std::string& path, int width, int height, const PixelWindow& pixels,
                    std::vector<std::string>& notes);

/// Throws InputError, with both sizes in its message, unless the sizes are equal.
void check_same_size(const ImageData& test, const ImageData& reference);

/// Throws InputError unless the mask is empty or has this many pixels.
void check_mask_size(const PixelMask& mask, std::size_t pixels);

/// The mean of the values of the pixels that count; NaN without such a pixel.
double masked_mean(const std::vector<float>& values, const PixelMask& mask = {});

/// A number and its standard error.
struct Estimate {
  double value = 0;
  double standard_error = 0;
};

/// The mean of value(i) over the pixels i with a non-zero byte in `counted`; there must be two. The
/// standard error assumes independent pixels, as those of pictures rendered without shared paths.
template <class F>
Estimate pixel_mean(const PixelMask& counted, const F& value) {
  double count = 0, mean = 0, squares = 0;  // Welford 1962
  for (std::size_t i = 0; i < counted.size(); ++i) {
    if (counted[i] == 0) continue;
    const double v = value(i);
    const double delta = v - mean;
    mean += delta / ++count;
    squares += delta * (v - mean);
  }
  return {mean, std::sqrt(squares / (count * (count - 1)))};
}

inline double mean_of_channels(const DVec3& v) { return (v.x + v.y + v.z) / 3; }

}  // namespace raytracing
