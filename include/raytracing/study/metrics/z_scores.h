#pragma once

#include <cstdint>
#include <optional>

#include "raytracing/io/image.h"
#include "raytracing/study/metrics/error_metrics.h"

namespace raytracing {

/// z = (x-r) / sqrt(var_x + var_r) of every channel of every pixel, where var is the picture's
/// layer variance.R/G/B: the variance of the pixel mean, 0 for a picture without the layers. Where
/// two pictures of many independent samples have the same expectation, z is nearly a standard
/// normal variable. Few samples of a long-tailed distribution give more large ones and a mean that
/// is not 0, since small values come with small variances. A variance that takes quasi-random
/// samples as independent is too large: then there are too few large ones.
struct ZScores {
  double share_196, share_3;  ///< share of |z| > 1.96 and > 3; NaN without scores
  double mean, rms;           ///< of z; expected: 0 and 1
  std::uint64_t scores;       ///< channels of pixels with a variance
  /// Channels without a score because both variances are 0: where the values agree, and where not.
  std::uint64_t no_variance_equal, no_variance_different;
  std::uint64_t
      not_finite;  ///< channels with a value or variance that is not finite, or a negative variance
};

/// The z-scores as channels R, G, B of a picture; NaN where there is no score. Throws InputError
/// for different sizes, and where neither picture has variance layers.
ImageData z_score_picture(const ImageData& test, const ImageData& reference);

/// The shares and the RMS to be expected for pictures of the same expectation.
struct ExpectedScores {
  double share_196, share_3, rms;
  int degrees;      ///< of freedom of Student's t; 0 = a normal distribution
  bool overstated;  ///< a variance takes Sobol' samples as independent; all will be smaller
};

/// The headers' samples and replicates give the degrees of freedom of each variance, which add up
/// as for variances of one size (Welch 1947). Pictures without a header count as of many samples.
ExpectedScores expected_scores(const ImageData& test, const ImageData& reference);

/// The z-scores; empty when neither picture has variance layers. Throws InputError as
/// error_metrics() does.
std::optional<ZScores> z_scores(const ImageData& test, const ImageData& reference,
                                const PixelMask& mask = {});

}  // namespace raytracing
