#pragma once

#include <cmath>
#include <cstddef>

#include "raytracing/study/error_metrics.h"

namespace raytracing {

/// A number and its standard error.
struct Estimate {
  double value = 0;
  double standard_error = 0;
};

/// Mean of value(i) over the pixels i that count, one byte of `counted` per pixel. The standard
/// error takes the pixels as independent, as those of our pictures are; there must be two.
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
