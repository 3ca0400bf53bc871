#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raytracing/render/film.h"
#include "raytracing/render/provenance.h"

namespace raytracing {

/// The entries of an image's header, in order. EXR keeps numbers as numbers; PNG stores text.
using ImageMetadata = NamedValues;

/// Float channels of one image, interleaved by pixel, top row first.
struct ImageData {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  ///< for example R, G, B, variance.R, variance.G, variance.B
  std::vector<float> values;          ///< width * height * channels.size(), linear
  ImageMetadata metadata;
  int integer_bits = 0;  ///< bits of an integer channel of a file that was read; 0 = float
};

/// The pixel means of a film, with the facts of its run as metadata. With `variance`, the channels
/// variance.R/G/B hold the variances of the means, infinite where a single replicate gives none.
ImageData to_image(const Film& film, RunFacts facts, bool variance = false);

enum class ImageFormat { png, exr };

/// The format that the extension of the name stands for, in upper or lower case. Throws UsageError
/// for anything but .png and .exr.
ImageFormat image_format(const std::string& path);

/// 8-bit sRGB code of a linear value (IEC 61966-2-1), rounded to nearest. Values outside [0,1] are
/// clamped; NaN becomes 0.
std::uint8_t srgb8(float linear);

/// The linear value of an sRGB one, both in [0,1] (IEC 61966-2-1).
double srgb_to_linear(double encoded);

/// The bytes of an image file. PNG holds the channels R, G, B with 8 bits and sRGB encoding; EXR
/// holds all channels as 32-bit floats, ZIP compressed. Throws OutputError.
std::string encode_image(const ImageData& image, ImageFormat format);

/// Reads an EXR or PNG file, which are distinguished by their first bytes. The channels begin with
/// R, G, B.
/// - EXR: all channels of the (first) part's data window, half, float and uint alike, as floats;
///   attributes that are text or a number become metadata. Deep and subsampled images are refused.
/// - PNG, 8 or 16 bit, grey or colour, decoded to linear by IEC 61966-2-1; text chunks become
///   metadata. Grey becomes three equal channels. A gamma other than that of sRGB is refused, and
///   so is transparency, since the background is not known.
/// At most 65536 pixels a side and 2^28 values. Throws InputError, "file: reason".
ImageData read_image(const std::string& path);

/// The same for the bytes of a file; `file` is used in messages only.
ImageData decode_image(const std::string& bytes, const std::string& file);

}  // namespace raytracing
