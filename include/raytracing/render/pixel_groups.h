#pragma once

#include <cstdint>
#include <vector>

namespace raytracing {

/// Which pixels are traced together, and share their paths: those of a group of edge x edge pixels,
/// one from each cell of a tile of edge x edge cells. A group of edge 1 is one pixel. In the
/// largest groups a cell is one pixel, since near pixels share best. In those between it is 2 x 2
/// pixels, so that as many groups interleave in a tile and their common errors look like grain
/// rather than blocks. The tiles are shifted, and the pixels within each cell exchanged, by random
/// numbers of the sample: groups have no fixed place that could be seen.
class PixelGroups {
 public:
  struct Pixel {
    int x, y;
    bool operator==(const Pixel&) const = default;
  };
  static constexpr int kMaxEdge = 16;
  /// Edge of the cells of groups of this edge, in pixels.
  static constexpr int stride(int edge) { return edge > 1 && edge < kMaxEdge ? 2 : 1; }
  /// Edge of their tiles, in pixels. Pixels that are this far apart share nothing.
  static constexpr int tile_edge(int edge) { return edge * stride(edge); }

  /// The groups of one sample of all pixels. `edge` is in [1, kMaxEdge].
  PixelGroups(int width, int height, int edge, std::uint64_t seed, std::uint64_t sample,
              std::uint64_t replicate);

  int tile_edge() const { return tile_edge(edge_); }
  /// The number of groups that interleave in a tile.
  int groups_per_tile() const { return stride_ * stride_; }
  /// The corner of the tiles' grid, in [0, tile_edge()) each, left of and above the picture's.
  Pixel shift() const { return {shift_x_, shift_y_}; }
  /// A group: `index` in [0, groups_per_tile()) of the tile in that column and row.
  struct Place {
    int column, row, index;
  };
  /// Sets `group` to those pixels of the group that lie in the picture.
  void pixels(const Place& place, std::vector<Pixel>& group) const;
  /// The place of the pixel's group.
  Place place_of(const Pixel& pixel) const;

 private:
  // How far the pixels of a cell are exchanged, cyclically in x and y.
  Pixel turn(int cell_x, int cell_y) const;

  int width_, height_, edge_, stride_;
  std::uint64_t key_;
  int shift_x_, shift_y_;
};

}  // namespace raytracing
