#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raytracing/render/provenance.h"

namespace raytracing {

/// The entries of an image's header, in order. EXR keeps numbers as numbers; PNG stores text.
using ImageMetadata = NamedValues;

/// Float channels of one picture, interleaved by pixel, top row first.
struct ImageData {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  ///< for example R, G, B, variance.R, variance.G, variance.B
  std::vector<float> values;          ///< width * height * channels.size(), linear
  ImageMetadata metadata;
  int integer_bits = 0;  ///< bits of an integer channel of a picture that was read; 0 = float
};

enum class ImageFormat { png, exr };

/// From the name's extension, in any case. Throws UsageError for anything but .png and .exr.
ImageFormat image_format(const std::string& path);

/// 8-bit sRGB code of a linear value (IEC 61966-2-1), rounded to nearest; outside [0,1] and NaN
/// go to the nearest end, NaN to 0.
std::uint8_t srgb8(float linear);

/// The linear value of an sRGB one, both in [0,1] (IEC 61966-2-1).
double srgb_to_linear(double encoded);

/// The picture as a complete file's bytes. PNG takes the channels R, G, B; EXR all channels as
/// 32-bit floats, ZIP compressed. Throws OutputError.
std::string encode_image(const ImageData& image, ImageFormat format);

}  // namespace raytracing
