#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "raytracing/study/metrics/error_metrics.h"

namespace raytracing {

/// A picture that serves as the truth, with an estimate of its own noise.
struct Reference {
  ImageData picture;  ///< R, G, B and perhaps other layers
  /// Estimate of each pixel's squared error, E[(r - truth)^2]; empty when not known.
  std::vector<DVec3> variance;
  std::string variance_source;  ///< the source of the variance, or why it is not known
  std::string unchecked = "";   ///< terms that the file's header does not contain
  /// Samples of the picture that count as black; empty when its header does not say.
  std::optional<std::uint64_t> non_finite_samples = {};
};

/// The error that a perfect picture would show against the reference: the mean of the reference's
/// own squared errors, weighted as in MSE and relMSE.
struct NoiseFloor {
  Estimate mse, relmse;
};

/// The pixels of the mask (empty = all) at which the reference is finite. Throws InputError for
/// fewer than two and for a mask of another size.
PixelMask counted_pixels(const ImageData& reference, const PixelMask& mask);

/// The noise floor; empty when the reference's variance is not known.
std::optional<NoiseFloor> noise_floor(const Reference& reference, const PixelMask& counted);

/// A reference with the pixels that count, those of a mask, and its noise floor.
struct GroundTruth {
  Reference reference;
  PixelMask counted;
  std::optional<NoiseFloor> floor;

  /// Throws InputError as counted_pixels() does.
  GroundTruth(Reference reference, const PixelMask& mask);
};

/// Joins two independent pictures of the same expectation and size into one with the channels R, G,
/// B (their mean), halfA.R ... and halfB.R ... .
ImageData join_halves(const ImageData& a, const ImageData& b);

/// Makes a reference of a picture. Its variance comes from the layers halfA and halfB, where
/// ((A - B) / 2)^2 has the expectation E[(r - truth)^2] of the mean r of both; else from the layers
/// variance, provided that the header shows them to be unbiased (independent samples, or
/// replicates) and that all are finite.
Reference to_reference(ImageData picture);

/// The terms that a file must meet to be the reference of a chart.
struct ReferenceTerms {
  int width, height;
  std::uint64_t scene_hash;
  std::string max_depth;             ///< "1" or "unlimited"
  std::vector<std::uint64_t> seeds;  ///< of the pictures that will be measured against it
};

/// Reads an EXR picture as the reference. Throws InputError for any other file, another size, and a
/// header with another scene or depth, a biased method, one of the seeds, or a rendering that was
/// stopped.
Reference read_reference(const std::string& path, const ReferenceTerms& terms);

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
