#include "raytracing/io/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string_view>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/io/image_library.h"

namespace raytracing {
namespace {

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

// The endings that need no library to be known: those of formats that carry the facts of a run or
// more than 8 bits.
constexpr std::array<std::string_view, 7> kKnownEndings{"png", "exr",  "tif", "tiff",
                                                        "jpg", "jpeg", "hdr"};

}  // namespace

std::string image_ending(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (!ending.empty()) ending.erase(0, 1);
  if (std::find(kKnownEndings.begin(), kKnownEndings.end(), ending) != kKnownEndings.end())
    return ending;
  const std::vector<std::string> endings = image_library().endings();
  if (std::find(endings.begin(), endings.end(), ending) == endings.end())
    throw UsageError(fmt::format("{}: the name of an image must end in one of .{}", path,
                                 fmt::join(endings, " .")));
  return ending;
}

bool holds_floats(const std::string& ending, bool as_float) {
  return ending == "exr" || ending == "hdr" || (as_float && ending.starts_with("tif"));
}

bool holds_metadata(const std::string& ending) {
  return ending != "hdr" &&
         std::find(kKnownEndings.begin(), kKnownEndings.end(), ending) != kKnownEndings.end();
}

std::string encode_image(const ImageData& image, const std::string& ending, bool as_float) {
  check_layout(image);
  return image_library().encode(image, ending, holds_floats(ending, as_float));
}

ImageData decode_image(const std::string& bytes, const std::string& file,
                       const std::string& layer) {
  try {
    return image_library().decode(bytes, layer);
  } catch (const InputError& error) {
    throw InputError(TextLocation{file}, error.what());
  }
}

ImageData read_image(const std::string& path, const std::string& layer) {
  return decode_image(read_file(path), path, layer);
}

}  // namespace raytracing
