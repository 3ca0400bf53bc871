#pragma once

#include <cstdint>
#include <vector>

#include "raytracing/math/vec.h"

namespace raytracing {

/// Sums over the samples of each pixel, in double precision, rows from the top.
class Film {
 public:
  /// Samples come in groups of equal size whose means count as independent. A group of a stopped
  /// rendering that is not complete counts for neither mean nor variance: its own variance is not
  /// known, and a part of a Sobol' sequence may be worse than the whole by far.
  struct Pixel {
    DVec3 sum{0.0};             ///< over the complete groups
    DVec3 sum_of_squares{0.0};  ///< of the sums of the complete groups
    DVec3 open_sum{0.0};        ///< over the group that is not complete
    std::uint64_t samples = 0;
    std::uint64_t groups = 0;   ///< that are complete
    std::uint64_t counted = 0;  ///< samples in complete groups

    /// `group_size` >= 1, the same in all calls.
    void add(const Rgb& sample, std::uint64_t group_size = 1) {
      open_sum += DVec3(sample);
      ++samples;
      if (samples == counted + group_size) close_group();
    }
    /// Mean over the complete groups; before the first one is complete, over what there is.
    DVec3 mean() const;
    /// Variance of the mean from the spread of the groups' means; 0 for fewer than two groups.
    DVec3 variance_of_mean() const;

   private:
    void close_group() {
      sum += open_sum;
      sum_of_squares += open_sum * open_sum;
      open_sum = DVec3(0.0);
      ++groups;
      counted = samples;
    }
  };

  Film(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Pixel& at(int x, int y) { return pixels_[static_cast<std::size_t>(y) * width_ + x]; }
  const Pixel& at(int x, int y) const { return pixels_[static_cast<std::size_t>(y) * width_ + x]; }

  /// Mean over all pixels of the pixels' means.
  DVec3 mean() const;
  /// Complete groups of the pixel that has the fewest.
  std::uint64_t fewest_groups() const;

 private:
  int width_, height_;
  std::vector<Pixel> pixels_;
};

}  // namespace raytracing
