#include "filter.h"

#include <algorithm>

namespace raytracing {
namespace {

Plane convolve_rows(const Plane& plane, const Kernel& kernel) {
  const std::size_t width = static_cast<std::size_t>(plane.width), radius = kernel.size() / 2;
  Plane result(plane.width, plane.height);
  std::vector<float> padded(width + 2 * radius);
  for (std::size_t start = 0; start < plane.values.size(); start += width) {
    const float* row = plane.values.data() + start;
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, width, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(padded.rbegin(), radius, row[width - 1]);
    float* out = result.values.data() + start;
    for (std::size_t k = 0; k < kernel.size(); ++k)
      for (std::size_t x = 0; x < width; ++x) out[x] += kernel[k] * padded[x + k];
  }
  return result;
}

Plane convolve_columns(const Plane& plane, const Kernel& kernel) {
  const std::size_t width = static_cast<std::size_t>(plane.width);
  const int radius = static_cast<int>(kernel.size() / 2);
  Plane result(plane.width, plane.height);
  for (int y = 0; y < plane.height; ++y) {
    float* out = result.values.data() + static_cast<std::size_t>(y) * width;
    for (int k = -radius; k <= radius; ++k) {
      const auto from = static_cast<std::size_t>(std::clamp(y + k, 0, plane.height - 1));
      const float* in = plane.values.data() + from * width;
      const float weight = kernel[static_cast<std::size_t>(k + radius)];
      for (std::size_t x = 0; x < width; ++x) out[x] += weight * in[x];
    }
  }
  return result;
}

}  // namespace

Plane convolve(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
  return convolve_columns(convolve_rows(plane, along_x), along_y);
}

}  // namespace raytracing
