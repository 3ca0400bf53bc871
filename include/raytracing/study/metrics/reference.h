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

}  // namespace raytracing
