#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "raytracing/io/image_file.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// Added to the square of the reference in relMSE, and to the sum of both values in SMAPE.
inline constexpr double kRelMseEpsilon = 0.01;

/// Errors of a test picture x against a reference r: means over the R, G and B of all pixels that
/// count and are finite in both pictures. Without such a pixel the means are NaN.
struct ErrorMetrics {
  double mse;        ///< mean (x-r)^2
  double rmse;       ///< sqrt(mse)
  double relmse;     ///< mean (x-r)^2 / (r^2 + kRelMseEpsilon)
  double mae;        ///< mean |x-r|
  double psnr;       ///< 10 log10(1 / mse), in dB for a peak of 1; infinite for equal pictures
  double smape;      ///< mean |x-r| / (|x| + |r| + kRelMseEpsilon)
  DVec3 mean_ratio;  ///< mean x / mean r per channel; NaN where both means are 0
  double largest;    ///< largest |x-r| of a channel
  int largest_x, largest_y;  ///< its pixel, the first of equals; -1 without pixels
  std::uint64_t non_finite_test, non_finite_reference;  ///< pixels left out of the means
  std::uint64_t pixels;                                 ///< pixels that the means are over
};

/// One byte per pixel, non-zero = counts; empty = all pixels count.
using PixelMask = std::vector<std::uint8_t>;

/// Throws InputError for pictures of different sizes, without R, G, B, or a mask of another size.
ErrorMetrics error_metrics(const ImageData& test, const ImageData& reference,
                           const PixelMask& mask = {});

/// A pixel counts where the linear mean of R, G, B is at least 1/2: white, not black.
PixelMask to_mask(const ImageData& mask);
/// Reads the mask from a picture of this size; no mask for the path "". Throws InputError.
PixelMask read_mask(const std::string& path, int width, int height);

/// What relMSE is, for people.
std::string relmse_formula();

/// Throws InputError, which tells both sizes, unless they are equal.
void check_same_size(const ImageData& test, const ImageData& reference);

/// Throws InputError unless the mask is empty or has this many pixels.
void check_mask_size(const PixelMask& mask, std::size_t pixels);

}  // namespace raytracing
