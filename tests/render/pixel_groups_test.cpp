#include "raytracing/render/pixel_groups.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace raytracing {
namespace {

using Pixel = PixelGroups::Pixel;

/// Every pixel of a picture of any size belongs to one group, the one of its place.
TEST(PixelGroups, HoldEveryPixelOnce) {
  std::vector<Pixel> group;
  for (const int edge : {1, 2, 4, 8, 16})
    for (const auto& [width, height] : {std::pair{13, 9}, {1, 1}, {64, 5}, {33, 40}})
      for (std::uint64_t sample = 0; sample < 5; ++sample) {
        const PixelGroups groups(width, height, edge, 3, sample, 0);
        std::map<std::pair<int, int>, int> count;
        const int tile = groups.tile_edge();
        for (int row = 0; row * tile < height + tile; ++row)
          for (int column = 0; column * tile < width + tile; ++column)
            for (int index = 0; index < groups.groups_per_tile(); ++index) {
              groups.pixels({column, row, index}, group);
              EXPECT_LE(group.size(), static_cast<std::size_t>(edge) * edge);
              for (const Pixel& pixel : group) {
                ++count[{pixel.x, pixel.y}];
                const PixelGroups::Place place = groups.place_of(pixel);
                EXPECT_EQ(place.column, column);
                EXPECT_EQ(place.row, row);
                EXPECT_EQ(place.index, index);
              }
            }
        EXPECT_EQ(count.size(), static_cast<std::size_t>(width) * height);
        for (const auto& [pixel, n] : count) EXPECT_EQ(n, 1);
      }
}

/// Over the samples the grid has every place, and a pixel has ever new companions. Seeds and
/// replicates have grids of their own.
TEST(PixelGroups, HaveNoFixedPlace) {
  std::set<std::pair<int, int>> shifts, companions;
  std::vector<Pixel> group;
  int same_seed = 0, same_replicate = 0;
  for (std::uint64_t sample = 0; sample < 2000; ++sample) {
    const PixelGroups groups(64, 64, 4, 1, sample, 0);
    const Pixel shift = groups.shift();
    shifts.insert({shift.x, shift.y});
    same_seed += PixelGroups(64, 64, 4, 2, sample, 0).shift() == shift;
    same_replicate += PixelGroups(64, 64, 4, 1, sample, 1).shift() == shift;
    const PixelGroups::Place place = groups.place_of({30, 30});
    groups.pixels(place, group);
    for (const Pixel& pixel : group) companions.insert({pixel.x, pixel.y});
  }
  EXPECT_EQ(shifts.size(), 64u);
  EXPECT_EQ(companions.size(), 225u);  // all less than 8 pixels away in x and y
  EXPECT_LT(same_seed, 80);            // 2000 / 64 by chance
  EXPECT_LT(same_replicate, 80);
}

}  // namespace
}  // namespace raytracing
