#pragma once

#include <cstdint>
#include <vector>

#include "raytracing/math/vec.h"

namespace raytracing {

/// Sums over the samples of each pixel, in double precision, rows from the top.
class Film {
 public:
  /// Samples come in replicates of equal size whose means count as independent. A replicate of a
  /// stopped rendering that is not complete counts for neither mean nor variance: its own variance
  /// is not known, and a part of a Sobol' sequence may be worse than the whole by far.
  struct Pixel {
    DVec3 sum{0.0};             ///< over the complete replicates
    DVec3 sum_of_squares{0.0};  ///< of the sums of the complete replicates
    DVec3 open_sum{0.0};        ///< over the replicate that is not complete
    std::uint64_t samples = 0;
    std::uint64_t replicates = 0;  ///< that are complete
    std::uint64_t counted = 0;     ///< samples in complete replicates

    /// `replicate_size` >= 1, the same in all calls.
    void add(const Rgb& sample, std::uint64_t replicate_size = 1) {
      open_sum += DVec3(sample);
      ++samples;
      if (samples == counted + replicate_size) close_replicate();
    }
    /// Mean over the complete replicates; before the first one is complete, over what there is.
    DVec3 mean() const;
    /// The number of samples that mean() is the mean of.
    std::uint64_t samples_in_mean() const { return replicates > 0 ? counted : samples; }
    /// Variance of the mean from the spread of the replicates' means; 0 for fewer than two.
    DVec3 variance_of_mean() const;

   private:
    void close_replicate() {
      sum += open_sum;
      sum_of_squares += open_sum * open_sum;
      open_sum = DVec3(0.0);
      ++replicates;
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
  /// Complete replicates of the pixel that has the fewest.
  std::uint64_t fewest_replicates() const;

 private:
  int width_, height_;
  std::vector<Pixel> pixels_;
};

}  // namespace raytracing
