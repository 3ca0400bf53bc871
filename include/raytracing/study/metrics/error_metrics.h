#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raytracing/study/metrics/pixels.h"

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

/// Throws InputError for pictures of different sizes, without R, G, B, or a mask of another size.
ErrorMetrics error_metrics(const ImageData& test, const ImageData& reference,
                           const PixelMask& mask = {});

/// The formula of relMSE as text.
std::string relmse_formula();

/// The weight of a squared error in relMSE, per channel: 1 / (r^2 + kRelMseEpsilon).
DVec3 relative_weight(const DVec3& r);

/// Each pixel's contribution to relMSE: the mean over R, G, B of (x-r)^2 / (r^2 + kRelMseEpsilon).
/// NaN where a picture is not finite. Throws InputError for pictures of different sizes.
std::vector<float> relative_squared_errors(const ImageData& test, const ImageData& reference);

}  // namespace raytracing
