#pragma once

#include <cstddef>
#include <vector>

namespace raytracing {

/// One channel of a picture, top row first.
struct Plane {
  int width, height;
  std::vector<float> values;

  Plane(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
};

/// Weights at -radius .. radius; an odd number of them.
using Kernel = std::vector<float>;

/// Filters rows with `along_x` and columns with `along_y`. The picture goes on beyond its edge with
/// the edge's values.
Plane convolve(const Plane& plane, const Kernel& along_x, const Kernel& along_y);

}  // namespace raytracing
