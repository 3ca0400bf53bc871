#pragma once

#include <optional>
#include <string>
#include <vector>

#include "raytracing/study/metrics/reference.h"

namespace raytracing {

/// Half the width of a 95 % interval in standard errors.
inline constexpr double kNormal95 = 1.960;
/// A standard normal variable exceeds it with a probability of 0.5 %.
inline constexpr double kOneSidedHalfPercent = 2.576;
/// The absolute value of a standard normal variable exceeds it with a probability of 0.5 %.
inline constexpr double kTwoSidedHalfPercent = 2.807;

/// Mean and variance per pixel of the pictures of one method, one per seed (Welford 1962).
class SeedMoments {
 public:
  /// Adds a finite picture of the same size as the others.
  void add(const ImageData& picture);

  int count() const { return count_; }
  const std::vector<DVec3>& mean() const { return mean_; }
  /// Unbiased variance of the mean between the seeds; count() >= 2.
  DVec3 variance_of_mean(std::size_t pixel) const;

 private:
  int count_ = 0;
  std::vector<DVec3> mean_, squares_;
};

/// How far the expectation of a method's pictures lies from the truth. With X the mean over N
/// seeds, S^2 the variance between them, r the reference and V its estimated squared error,
///   (X - r)^2 - S^2 / N - V
/// has the expectation bias^2 at every pixel, when seeds and reference are independent and the
/// reference is unbiased. The standard errors come from the scatter over the pixels: noise, and
/// where there is bias its own spread over the picture, which makes them too large.
struct BiasEstimate {
  Estimate squared;           ///< mean bias^2; scattered about 0 for an unbiased method
  Estimate relative_squared;  ///< the same with the weights of relMSE
  /// Sum of X over sum of r, less 1. The standard error holds when there is no bias.
  Estimate mean_ratio;
  /// Whether relative_squared or mean_ratio differs from 0 by more than noise and rounding. An
  /// unbiased method is flagged in at most 1 of 100 charts: half of that for each of the two.
  bool detected = false;

  /// sqrt(max(0, squared)) and the same of the ends of its 95 % interval.
  double rms() const;
  double rms_low() const;
  double rms_high() const;
};

/// The estimate as one line of text.
std::string to_text(const BiasEstimate& bias);

/// The bias; empty for fewer than two seeds, or when the noise of the reference is not known.
std::optional<BiasEstimate> estimate_bias(const SeedMoments& moments, const Reference& reference,
                                          const PixelMask& counted);

}  // namespace raytracing
