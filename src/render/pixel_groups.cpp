#include "raytracing/render/pixel_groups.h"

#include "raytracing/integrator/path_tracer.h"
#include "raytracing/math/numeric.h"
#include "raytracing/sampling/hash.h"

namespace raytracing {

static_assert(square(PixelGroups::kMaxEdge) == PathTracer::kMaxSamples);

PixelGroups::PixelGroups(int width, int height, int edge, std::uint64_t seed, std::uint64_t sample,
                         std::uint64_t replicate)
    : width_(width), height_(height), edge_(edge), stride_(stride(edge)) {
  std::uint64_t key = mix_bits(seed + 0x632be59bd9b4e019u);
  key = mix_bits(key ^ sample);
  key_ = mix_bits(key + replicate * 0xd1342543de82ef95u);
  const auto tile = static_cast<std::uint64_t>(tile_edge());
  shift_x_ = static_cast<int>((key_ & 0xffffffffu) % tile);
  shift_y_ = static_cast<int>((key_ >> 32) % tile);
}

PixelGroups::Pixel PixelGroups::turn(int cell_x, int cell_y) const {
  if (stride_ == 1) return {0, 0};
  const std::uint64_t cell =
      std::uint64_t{static_cast<std::uint32_t>(cell_y)} << 32 | static_cast<std::uint32_t>(cell_x);
  const std::uint64_t bits = mix_bits(key_ ^ mix_bits(cell));
  const auto cell_edge = static_cast<std::uint64_t>(stride_);
  return {static_cast<int>((bits & 0xffffffffu) % cell_edge),
          static_cast<int>((bits >> 32) % cell_edge)};
}

void PixelGroups::pixels(const Place& place, std::vector<Pixel>& group) const {
  group.clear();
  const auto [column, row, index] = place;
  for (int cy = row * edge_; cy < (row + 1) * edge_; ++cy)
    for (int cx = column * edge_; cx < (column + 1) * edge_; ++cx) {
      const Pixel by = turn(cx, cy);
      const int x = cx * stride_ + (index % stride_ + by.x) % stride_ - shift_x_;
      const int y = cy * stride_ + (index / stride_ + by.y) % stride_ - shift_y_;
      if (x >= 0 && x < width_ && y >= 0 && y < height_) group.push_back({x, y});
    }
}

PixelGroups::Place PixelGroups::place_of(const Pixel& pixel) const {
  const int x = pixel.x + shift_x_, y = pixel.y + shift_y_;
  const Pixel by = turn(x / stride_, y / stride_);
  const int ix = (x % stride_ - by.x + stride_) % stride_;
  const int iy = (y % stride_ - by.y + stride_) % stride_;
  return {x / tile_edge(), y / tile_edge(), iy * stride_ + ix};
}

}  // namespace raytracing
