#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "raytracing/io/image.h"

namespace raytracing {

/// Pictures of a made-up truth with made-up noise, independent per pixel; as renders have it, the
/// noise is skewed, grows with the value, and its channels go together.
class NoisyPictures {
 public:
  NoisyPictures(int size, std::uint64_t seed) : size_(size), engine_(seed) {}

  /// Radiance of a channel of pixel i: smooth, from 0.05 to 1.
  double truth(std::size_t i, int channel) const {
    const double u = static_cast<double>(i % static_cast<std::size_t>(size_)) / size_;
    return 0.05 + (0.95 - 0.2 * channel) * u * u;
  }
  std::size_t pixels() const {
    return static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_);
  }
  /// Variance of a channel of pixel i for noise of size `sigma`.
  double variance(std::size_t i, int channel, double sigma) const {
    return sigma * sigma * truth(i, channel) * truth(i, channel);
  }

  /// `factor` times the truth, with noise of the relative standard deviation `sigma`.
  ImageData picture(double sigma, double factor = 1) {
    ImageData image;
    image.width = image.height = size_;
    image.channels = {"R", "G", "B"};
    std::exponential_distribution<double> waiting;
    for (std::size_t i = 0; i < pixels(); ++i) {
      const double shared = waiting(engine_) - 1;
      for (int c = 0; c < 3; ++c) {
        const double own = waiting(engine_) - 1;
        const double noise = sigma * std::sqrt(0.5) * (shared + own);
        image.values.push_back(static_cast<float>(factor * truth(i, c) * (1 + noise)));
      }
    }
    return image;
  }

 private:
  int size_;
  std::mt19937_64 engine_;
};

}  // namespace raytracing
