#include "raytracing/io/image_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "image_decoders.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"

namespace raytracing {
namespace {

constexpr std::string_view kExrMagic = "\x76\x2f\x31\x01";
constexpr std::string_view kPngMagic = "\x89PNG\r\n\x1a\n";

ImageData decode(const std::string& bytes) {
  if (bytes.starts_with(kExrMagic)) return decode_exr(bytes);
  if (bytes.starts_with(kPngMagic)) return decode_png(bytes);
  throw InputError("neither an EXR nor a PNG picture");
}

}  // namespace

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
    std::string what = error.what();  // a library's text may have several lines
    std::replace(what.begin(), what.end(), '\n', ' ');
    throw InputError(TextLocation{file}, what);
  }
}

ImageData read_image(const std::string& path) { return decode_image(read_file(path), path); }

}  // namespace raytracing
