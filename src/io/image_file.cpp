#include "raytracing/io/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <set>

#include "image_encoders.h"
#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

/// The linear value at which each code from 1 to 255 begins: the sRGB decoding of code - 1/2.
std::array<double, 255> make_code_thresholds() {
  std::array<double, 255> thresholds{};
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    thresholds[i] = srgb_to_linear((static_cast<double>(i) + 0.5) / 255);
  }
  return thresholds;
}

void check_layout(const ImageData& image) {
  const std::set<std::string> names(image.channels.begin(), image.channels.end());
  if (image.width < 1 || image.height < 1 || names.empty()) {
    throw OutputError("an image needs at least one pixel and one channel");
  }
  if (names.size() != image.channels.size()) {
    throw OutputError("an image must not have two channels of the same name");
  }
  const auto count = static_cast<std::size_t>(image.width) *
                     static_cast<std::size_t>(image.height) * image.channels.size();
  if (image.values.size() != count) {
    throw OutputError("an image's values do not fill its pixels and channels");
  }
}

}  // namespace

ImageFormat image_format(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (extension == ".png") return ImageFormat::png;
  if (extension == ".exr") return ImageFormat::exr;
  throw UsageError(path + ": the name of an image must end in .png or .exr");
}

double srgb_to_linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::uint8_t srgb8(float linear) {
  static const std::array<double, 255> thresholds = make_code_thresholds();
  if (!(linear > 0)) return 0;  // catches NaN, too
  const auto above = std::upper_bound(thresholds.begin(), thresholds.end(), linear);
  return static_cast<std::uint8_t>(above - thresholds.begin());
}

std::string encode_image(const ImageData& image, ImageFormat format) {
  check_layout(image);
  return format == ImageFormat::png ? encode_png(image) : encode_exr(image);
}

}  // namespace raytracing
