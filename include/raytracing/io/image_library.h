#pragma once

#include <future>
#include <string>
#include <vector>

#include "raytracing/io/image.h"

namespace raytracing {

/// White text in a picture.
struct TextLabel {
  std::string text;
  int x, y;    ///< the pixel of its middle, and of its top
  int height;  ///< of the font, in pixels
};

/// What the program asks of OpenImageIO. Loading that library takes 0.2 s on Debian 12, since it
/// depends on 260 others, so a module of the program holds what needs it.
struct ImageLibrary {
  /// Returns the endings of all formats that can be written, in lower case.
  std::vector<std::string> (*endings)();
  /// Returns the bytes of a file of floats or of 8-bit codes; see encode_image(). The layout of the
  /// image must be right.
  std::string (*encode)(const ImageData& image, const std::string& ending, bool floats);
  /// Returns the image in the bytes of a file; see read_image(). InputErrors do not name the file.
  ImageData (*decode)(const std::string& bytes, const std::string& layer);
  /// Returns the colours of the map "magma" at values in [0,1]: linear R, G, B for each.
  std::vector<float> (*magma)(const std::vector<float>& values);
  /// Draws the labels on an image with the channels R, G, B. Throws OutputError without their font.
  void (*draw_labels)(ImageData& image, const std::vector<TextLabel>& labels);
};

/// Returns the library, which the first call loads: the file lib/raytracing/openimageio.so below
/// the folder of the program or below the folder above that one. Throws std::runtime_error if it
/// cannot be loaded.
const ImageLibrary& image_library();

/// Loads the library in a thread of its own, while a scene is loaded and rendered.
class ImageLibraryPreload {
 public:
  /// Throws std::runtime_error if the module is missing.
  ImageLibraryPreload();

  /// Throws std::runtime_error if the library could not be loaded; does not wait for it.
  void check() const;

 private:
  std::shared_future<void> loading_;  ///< waits for its thread when it is destroyed
};

}  // namespace raytracing
