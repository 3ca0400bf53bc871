#include "raytracing/io/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <set>
#include <string_view>

#include "image_codecs.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"

namespace raytracing {
namespace {

// The linear value at which each code from 1 to 255 begins: the sRGB decoding of code - 1/2.
std::array<double, 255> make_code_thresholds() {
  std::array<double, 255> thresholds{};
  for (std::size_t i = 0; i < thresholds.size(); ++i)
    thresholds[i] = srgb_to_linear((static_cast<double>(i) + 0.5) / 255);
  return thresholds;
}

void check_layout(const ImageData& image) {
  const std::set<std::string> names(image.channels.begin(), image.channels.end());
  if (image.width < 1 || image.height < 1 || names.empty())
    throw OutputError("an image needs at least one pixel and one channel");
  if (names.size() != image.channels.size())
    throw OutputError("an image must not have two channels of the same name");
  const auto count = static_cast<std::size_t>(image.width) *
                     static_cast<std::size_t>(image.height) * image.channels.size();
  if (image.values.size() != count)
    throw OutputError("an image's values do not fill its pixels and channels");
}

constexpr std::string_view kExrMagic = "\x76\x2f\x31\x01";
constexpr std::string_view kPngMagic = "\x89PNG\r\n\x1a\n";

ImageData decode(const std::string& bytes) {
  if (bytes.starts_with(kExrMagic)) return decode_exr(bytes);
  if (bytes.starts_with(kPngMagic)) return decode_png(bytes);
  throw InputError("neither an EXR nor a PNG image");
}

}  // namespace

ImageData to_image(const Film& film, RunFacts facts, bool variance) {
  ImageData image;
  image.width = film.width();
  image.height = film.height();
  image.channels = {"R", "G", "B"};
  if (variance)
    image.channels.insert(image.channels.end(), {"variance.R", "variance.G", "variance.B"});
  image.values.reserve(image.channels.size() * film.width() * film.height());
  const auto append = [&image](const DVec3& v) {
    for (const double c : {v.x, v.y, v.z}) image.values.push_back(static_cast<float>(c));
  };
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      const Film::Pixel& pixel = film.at(x, y);
      append(pixel.mean());
      // Of a single sample or replicate no finite value would be honest.
      if (variance)
        append(pixel.replicates < 2 ? DVec3(std::numeric_limits<double>::infinity())
                                    : pixel.variance_of_mean());
    }
  if (!variance) {  // there are no layers that these facts could describe
    facts.variance_kind.reset();
    facts.pixel_correlation.reset();
  }
  image.metadata = named_values(facts);
  return image;
}

ImageFormat image_format(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
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

void check_image_size(std::int64_t width, std::int64_t height, std::size_t channels) {
  constexpr std::int64_t kMaxSide = 65536;
  constexpr std::uint64_t kMaxValues = std::uint64_t{1} << 28;
  if (width < 1 || height < 1) throw InputError("has no pixels");
  if (width <= kMaxSide && height <= kMaxSide && channels <= kMaxValues &&
      static_cast<std::uint64_t>(width * height) * channels <= kMaxValues)
    return;
  throw InputError(fmt::format("{}x{} pixels of {} channels are more than can be read", width,
                               height, channels));
}

ImageData decode_image(const std::string& bytes, const std::string& file) {
  try {
    return decode(bytes);
  } catch (const InputError& error) {
    throw InputError(TextLocation{file}, error.what());
  }
}

ImageData read_image(const std::string& path) { return decode_image(read_file(path), path); }

}  // namespace raytracing
