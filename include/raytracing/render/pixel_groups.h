#pragma once

#include <cstdint>
#include <vector>

namespace raytracing {

/// Which pixels share their paths: those of a group of edge x edge, one from each cell of a tile of
/// edge x edge cells. A cell is kStride x kStride pixels, so that as many groups interleave in a
/// tile. The tiles are shifted, and the pixels within each cell exchanged, by random numbers of the
/// sample: groups have no fixed place that could be seen.
class PixelGroups {
 public:
  struct Pixel {
    int x, y;
    bool operator==(const Pixel&) const = default;
  };
  static constexpr int kStride = 2;

  /// Of one sample of all pixels. `edge` >= 1.
  PixelGroups(int width, int height, int edge, std::uint64_t seed, std::uint64_t sample,
              std::uint64_t replicate);

  int tile_edge() const { return edge_ * kStride; }
  /// The corner of the tiles' grid, in [0, tile_edge()) each, left of and above the picture's.
  Pixel shift() const { return {shift_x_, shift_y_}; }
  /// The pixels of group `index` in [0, kStride^2) of the tile of that column and row, as far as
  /// they lie in the picture.
  void pixels(int column, int row, int index, std::vector<Pixel>& group) const;
  /// Column, row and index of the group of a pixel.
  struct Place {
    int column, row, index;
  };
  Place place_of(const Pixel& pixel) const;

 private:
  // What the pixels of a cell are turned by, in x and y.
  Pixel turn(int cell_x, int cell_y) const;

  int width_, height_, edge_;
  std::uint64_t key_;
  int shift_x_, shift_y_;
};

}  // namespace raytracing
