#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/render/provenance.h"

namespace raytracing {

/// The entries of an image's header, in order. EXR keeps numbers as numbers; other formats store
/// text.
using ImageMetadata = NamedValues;

/// A rectangle of pixels, in pixels; y counts down.
struct PixelWindow {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelWindow&) const = default;
};

/// Float channels of one image, interleaved by pixel, top row first.
struct ImageData {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  ///< for example R, G, B, variance.R, variance.G, variance.B
  std::vector<float> values;          ///< width * height * channels.size(), linear, Rec. 709
  ImageMetadata metadata;
  int integer_bits = 0;  ///< bits of an integer channel of a file that was read; 0 = float
  /// The whole picture that the pixels are a part of, seen from their first one: x and y are 0 or
  /// negative for a crop. Empty where the pixels are the whole picture.
  std::optional<PixelWindow> whole = {};
  /// What reading changed or chose, one sentence each: a conversion, the layer that was read.
  std::vector<std::string> notes = {};
};

/// Layers of channels that the program itself writes beside R, G, B and reads back.
inline constexpr std::string_view kStatisticsLayers[] = {"variance", "halfA", "halfB"};

/// Returns the ending of an image's name, in lower case and without its dot. Throws UsageError for
/// one that cannot be written, with the list of those that can; only for other endings than those
/// in the program's help is the image library loaded.
std::string image_ending(const std::string& path);

/// Whether files of this ending hold linear floats: always, or where it is asked for.
bool holds_floats(const std::string& ending, bool as_float = false);

/// Whether files of this ending carry the metadata of an image.
bool holds_metadata(const std::string& ending);

/// The bytes of an image file of this ending. EXR holds all channels as 32-bit floats, ZIP
/// compressed; HDR holds R, G, B with a shared exponent; TIFF holds them as 32-bit floats with
/// `as_float`; all else holds R, G, B with 8 bits and sRGB encoding. The metadata are attributes of
/// EXR, text of PNG, and lines "name: value" of the image description of TIFF and JPEG; other
/// formats cannot carry them. Throws OutputError.
std::string encode_image(const ImageData& image, const std::string& ending, bool as_float = false);

/// Reads an EXR, PNG, TIFF, JPEG, HDR, PFM or PNM file, which are distinguished by their first
/// bytes. The channels begin with R, G, B; grey becomes three equal channels.
/// - The layer is the one named, of a file with several; otherwise the channels R, G, B, those that
///   are called beauty or Combined, or the only layer there is. Of the other channels, those of
///   kStatisticsLayers are read along with R, G, B, no others.
/// - Integers are decoded to linear by their ICC profile, their gamma or IEC 61966-2-1, floats are
///   linear. Chromaticities other than those of Rec. 709 are converted, without adaptation of the
///   white point.
/// - Deep and subsampled images are refused, and so is transparency, since the background is not
///   known; the colours of EXR are those over black.
/// At most 65536 pixels a side and 2^28 values. Throws InputError, "file: reason".
ImageData read_image(const std::string& path, const std::string& layer = "");

/// The same for the bytes of a file; `file` is used in messages only.
ImageData decode_image(const std::string& bytes, const std::string& file,
                       const std::string& layer = "");

}  // namespace raytracing
