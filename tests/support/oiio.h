#pragma once
// Reads and writes files with OpenImageIO itself. Only for the tests that tests/CMakeLists.txt
// names.

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/temp_dir.h"

namespace raytracing {

struct ReadImage {
  OIIO::ImageSpec spec;
  std::vector<float> values;  ///< interleaved by pixel, top row first

  bool has(const std::string& channel) const {
    return std::count(spec.channelnames.begin(), spec.channelnames.end(), channel) > 0;
  }
  float at(int x, int y, const std::string& channel) const {
    const auto& names = spec.channelnames;
    const auto found = std::find(names.begin(), names.end(), channel);
    if (found == names.end()) throw std::runtime_error("no channel " + channel);
    const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(spec.width) +
                       static_cast<std::size_t>(x);
    return values.at(pixel * names.size() + static_cast<std::size_t>(found - names.begin()));
  }
  /// The attribute as text; "" when it is not there.
  std::string attribute(const std::string& name) const {
    const OIIO::ParamValue* value = spec.find_attribute(name);
    return value == nullptr ? "" : value->get_string();
  }
};

inline ReadImage read_with_oiio(const std::string& path) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) throw std::runtime_error(OIIO::geterror());
  ReadImage image{input->spec(), {}};
  image.values.resize(image.spec.image_pixels() * static_cast<std::size_t>(image.spec.nchannels));
  if (!input->read_image(0, 0, 0, -1, OIIO::TypeFloat, image.values.data()))
    throw std::runtime_error(input->geterror());
  return image;
}

/// Writes the values, converted to the type of `spec`; 1 becomes the largest integer. Returns the
/// path.
template <class Value>
std::string write_oiio(const TempDir& folder, const std::string& name, const OIIO::ImageSpec& spec,
                       const std::vector<Value>& values) {
  const std::string path = folder / name;
  const auto output = OIIO::ImageOutput::create(path);
  if (!output || !output->open(path, spec)) throw std::runtime_error(OIIO::geterror());
  const bool written = spec.tile_width == 0
                           ? output->write_image(OIIO::BaseTypeFromC<Value>::value, values.data())
                           : output->write_tiles(0, spec.width, 0, spec.height, 0, 1,
                                                 OIIO::BaseTypeFromC<Value>::value, values.data());
  if (!written) throw std::runtime_error(output->geterror());
  output->close();
  return path;
}

}  // namespace raytracing
