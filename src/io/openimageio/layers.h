#pragma once
// Which channels of a file are the picture.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace raytracing::openimageio {

/// One of the images in a file.
struct Part {
  std::string name;  ///< "" where the format has no names
  std::vector<std::string> channels;
  bool deep = false;  ///< its pixels hold lists of samples
};

/// The channels to read, all of one part.
struct LayerChoice {
  struct Channel {
    int index;         ///< in the part
    std::string name;  ///< in the picture that is read
  };
  std::size_t part = 0;
  std::array<int, 3> rgb{};        ///< indices of red, green and blue; equal for grey
  int alpha = -1;                  ///< index of its channel A; -1 without one
  std::vector<Channel> others;     ///< of kStatisticsLayers
  std::vector<std::string> notes;  ///< what a user would not expect

  bool is_grey() const { return rgb[0] == rgb[1]; }
};

/// Chooses the layer of this name, or the picture itself for "" (see read_image()). Throws
/// InputError, with a list of the layers or channels there are.
LayerChoice choose_layer(const std::vector<Part>& parts, const std::string& wanted);

}  // namespace raytracing::openimageio
