#pragma once

#include <cstdint>
#include <vector>

#include "raytracing/math/vec.h"

namespace raytracing {

/// Sums over the samples of each pixel, in double precision, rows from the top.
class Film {
 public:
  struct Pixel {
    DVec3 sum{0.0};
    DVec3 sum_of_squares{0.0};
    std::uint64_t samples = 0;

    void add(const Rgb& sample) {
      const DVec3 s(sample);
      sum += s;
      sum_of_squares += s * s;
      ++samples;
    }
    DVec3 mean() const { return samples == 0 ? sum : sum / static_cast<double>(samples); }
    /// Sample variance of the mean, as if the samples were independent; 0 for fewer than two.
    DVec3 variance_of_mean() const;
  };

  Film(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Pixel& at(int x, int y) { return pixels_[static_cast<std::size_t>(y) * width_ + x]; }
  const Pixel& at(int x, int y) const { return pixels_[static_cast<std::size_t>(y) * width_ + x]; }

  /// Mean over all pixels of the pixels' means.
  DVec3 mean() const;

 private:
  int width_, height_;
  std::vector<Pixel> pixels_;
};

}  // namespace raytracing
