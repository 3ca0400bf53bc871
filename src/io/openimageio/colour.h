#pragma once
// From the values of a file to linear ones of Rec. 709.

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fences.h"

namespace raytracing::openimageio {

/// Decodes red, green and blue as the file's colour profile, gamma and chromaticities say; without
/// them, integers are sRGB and floats are linear values of Rec. 709.
class ColourDecoder {
 public:
  /// Judges a file by its header and what it states otherwise. `largest_code` is that of its
  /// integers, 0 for floats. Throws InputError for what cannot be converted.
  ColourDecoder(const OIIO::ImageSpec& spec, double largest_code, const StatedColours& stated);
  ~ColourDecoder();

  /// Decodes `pixels` pixels in place. Each has `stride` values, the first three of which are red,
  /// green and blue; integers lie in [0,1].
  void decode(float* values, std::size_t pixels, std::size_t stride) const;

  /// Whether a decoded channel depends on others.
  bool mixes_channels() const { return profile_ || to_rec709_; }

  const std::vector<std::string>& notes() const { return notes_; }

 private:
  class Profile;

  double largest_code_;
  double gamma_;
  std::unique_ptr<const Profile> profile_;  ///< null where values are sRGB, linear, or of a gamma
  std::optional<glm::dmat3> to_rec709_;     ///< empty where the primaries are those already
  std::vector<std::string> notes_;
};

}  // namespace raytracing::openimageio
