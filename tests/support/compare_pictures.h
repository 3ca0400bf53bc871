#pragma once
// Compares two noisy pictures of the same thing by z-tests.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "raytracing/math/vec.h"
#include "support/statistics.h"

namespace raytracing {

/// A picture with the variance of each pixel's mean, as `spp` independent samples give them.
struct NoisyPicture {
  int width = 0, height = 0;
  double spp = 0;
  std::vector<DVec3> mean, variance;  ///< top row first
};

struct PictureComparison {
  std::vector<DVec3> z;     ///< of the pixels
  double pixel_p = 1;       ///< the smallest of pixels and channels
  double block_p = 1;       ///< the smallest of blocks of 8 x 8 pixels and channels
  double chi_square_p = 1;  ///< the smallest of the channels: sum of z^2 of the blocks
  double mean_p = 1;        ///< the smallest of the channels: mean of the picture
  bool same = true;         ///< no p below its share of the level

  std::string text() const {
    return fmt::format("p of pixels {:.2g}, blocks {:.2g}, chi-square {:.2g}, means {:.2g}\n",
                       pixel_p, block_p, chi_square_p, mean_p);
  }
};

namespace compare_detail {

/// Sums over a pixel or a part of the picture.
///
/// Light paths have skewed radiances: rarely a very bright one. Without such a sample both mean and
/// estimated variance are too small, and their quotient is a z far below 0 too often. The reference
/// knows the variance of a sample much better, so that the test's own estimate is not taken below
/// it. With such a sample the mean is far too large, but so is then the estimated variance, and z
/// stays small. Hence the larger of the two.
struct Sums {
  DVec3 difference{0.0};
  DVec3 estimated{0.0};  ///< the test's variance, as it estimates it itself
  DVec3 expected{0.0};   ///< the test's variance, as the reference tells it
  DVec3 reference{0.0};  ///< the reference's variance

  void add(const NoisyPicture& a, const NoisyPicture& b, std::size_t pixel) {
    difference += a.mean[pixel] - b.mean[pixel];
    estimated += a.variance[pixel];
    expected += b.variance[pixel] * (b.spp / a.spp);
    reference += b.variance[pixel];
  }
  DVec3 variance() const { return glm::max(estimated, expected) + reference; }
  DVec3 z() const {
    DVec3 result(0.0);
    for (int c = 0; c < 3; ++c) {
      if (variance()[c] > 0)
        result[c] = difference[c] / std::sqrt(variance()[c]);
      else if (difference[c] != 0)
        result[c] = std::copysign(1e9, difference[c]);
    }
    return result;
  }
};

inline double smallest_p(const DVec3& z) {
  return std::min({normal_p_value(z.x), normal_p_value(z.y), normal_p_value(z.z)});
}

}  // namespace compare_detail

/// The probability that pictures of the same scene are called different is at most about `level`.
inline PictureComparison compare_pictures(const NoisyPicture& test, const NoisyPicture& reference,
                                          double level = kFamilyLevel) {
  using compare_detail::smallest_p, compare_detail::Sums;
  constexpr int kBlock = 8;
  const int columns = (test.width + kBlock - 1) / kBlock;
  const int rows = (test.height + kBlock - 1) / kBlock;
  std::vector<Sums> blocks(static_cast<std::size_t>(columns) * rows);
  Sums all;
  PictureComparison result;
  for (std::size_t i = 0; i < test.mean.size(); ++i) {
    Sums pixel;
    pixel.add(test, reference, i);
    const int x = static_cast<int>(i) % test.width, y = static_cast<int>(i) / test.width;
    blocks[static_cast<std::size_t>(y / kBlock) * columns + x / kBlock].add(test, reference, i);
    all.add(test, reference, i);
    result.z.push_back(pixel.z());
    result.pixel_p = std::min(result.pixel_p, smallest_p(pixel.z()));
  }
  DVec3 squares(0.0), degrees(0.0);
  for (const Sums& block : blocks) {
    const DVec3 z = block.z();
    result.block_p = std::min(result.block_p, smallest_p(z));
    squares += z * z;
    for (int c = 0; c < 3; ++c) degrees[c] += block.variance()[c] > 0;
  }
  for (int c = 0; c < 3; ++c)
    if (degrees[c] > 0)
      result.chi_square_p = std::min(result.chi_square_p, gamma_q(degrees[c] / 2, squares[c] / 2));
  result.mean_p = smallest_p(all.z());
  // Four families share the level. The channels count as independent tests, which is cautious.
  const auto share = [&](std::size_t tests) {
    return sidak_level(level / 4, 3.0 * static_cast<double>(tests));
  };
  result.same = result.pixel_p >= share(test.mean.size()) &&
                result.block_p >= share(blocks.size()) && result.chi_square_p >= share(1) &&
                result.mean_p >= share(1);
  return result;
}

}  // namespace raytracing
