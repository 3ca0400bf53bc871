#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "raytracing/io/image_file.h"
#include "raytracing/study/pixel_mean.h"

namespace raytracing {

/// A picture that stands for the truth, and what is known of its own noise.
struct Reference {
  ImageData picture;  ///< R, G, B and perhaps other layers
  /// Estimate of each pixel's squared error, E[(r - truth)^2]; empty when not known.
  std::vector<DVec3> variance;
  std::string variance_source;  ///< how it is known, or why not, for people
  std::string unchecked = "";   ///< terms that the file's header does not tell, for people
};

/// What a perfect picture would measure against the reference: the mean of the reference's own
/// squared errors, weighted as in MSE and relMSE.
struct NoiseFloor {
  Estimate mse, relmse;
};

/// The weight of a squared error in relMSE, per channel: 1 / (r^2 + kRelMseEpsilon).
DVec3 relative_weight(const DVec3& r);

/// The pixels of the mask (empty = all) at which the reference is finite. Throws InputError for
/// fewer than two and for a mask of another size.
PixelMask counted_pixels(const ImageData& reference, const PixelMask& mask);

/// Empty when the reference's noise is not known.
std::optional<NoiseFloor> noise_floor(const Reference& reference, const PixelMask& counted);

/// Two pictures of the same expectation and size, independent of each other, as R, G, B (their
/// mean), halfA.R ... and halfB.R ... .
ImageData join_halves(const ImageData& a, const ImageData& b);

/// Takes the noise from the layers halfA and halfB, where ((A - B) / 2)^2 has the expectation
/// E[(r - truth)^2] of the mean r of both; else from the layers variance, unless their header does
/// not show them to be unbiased (independent samples, or replicates) or some are no finite numbers.
Reference to_reference(ImageData picture);

/// What a file must agree with to be the reference.
struct ReferenceTerms {
  int width, height;
  std::uint64_t scene_hash;
  std::string max_depth;             ///< "1" or "unlimited"
  std::vector<std::uint64_t> seeds;  ///< of the pictures that will be measured against it
};

/// Reads an EXR picture as the reference. Throws InputError when it is none, of another size, or
/// when its header tells of another scene or depth, of a biased method, of one of the seeds, or of
/// a rendering that was stopped.
Reference read_reference(const std::string& path, const ReferenceTerms& terms);

}  // namespace raytracing
