#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/render/layers.h"

namespace raytracing {

/// The layers of a picture while it is rendered: sums over the samples of each pixel, beside those
/// of its Film. A layer that follows from the film takes no memory.
class LayerFilm {
 public:
  /// No layers.
  LayerFilm() = default;
  /// The layers, each once, of a picture of this size.
  LayerFilm(std::span<const Layer* const> layers, int width, int height);

  /// Whether any layer sums over samples. Without one, add() does nothing.
  bool sums_samples() const { return sums_samples_; }
  /// Adds a sample that `pixel` of the film has just got. Threads may add to different pixels at
  /// once. A value that is not finite is left out.
  void add(int x, int y, const Film::Pixel& pixel, const LayerSample& sample);

  bool has(std::string_view layer) const;
  /// The names of all channels.
  std::vector<std::string> channels() const;
  /// Appends the values of all channels of the pixel. They are means over the samples of which
  /// pixel.mean() is the mean.
  void append_values(int x, int y, const Film::Pixel& pixel, std::vector<float>& values) const;

 private:
  // Sums as in Film::Pixel. The counts are those of the values that were added.
  struct Sum {
    DVec3 sum{0.0}, open_sum{0.0};
    std::uint64_t count = 0, open_count = 0;
  };
  struct Plane {
    const Layer* layer;
    std::vector<Sum> sums;  // rows from the top; empty for a layer that follows from the film
  };

  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }

  int width_ = 0;
  bool sums_samples_ = false;
  std::vector<Plane> planes_;
};

}  // namespace raytracing
