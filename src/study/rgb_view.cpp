#include "raytracing/study/rgb_view.h"

#include <algorithm>

#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

constexpr std::array<const char*, 3> kNames = {"R", "G", "B"};

std::size_t offset(const ImageData& image, const std::string& name) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), name);
  return static_cast<std::size_t>(found - image.channels.begin());
}

}  // namespace

RgbView::RgbView(const ImageData& image, const std::string& prefix)
    : values_(image.values.data()),
      stride_(image.channels.size()),
      pixels_(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
  for (std::size_t c = 0; c < 3; ++c) {
    offsets_[c] = offset(image, prefix + kNames[c]);
    if (offsets_[c] == stride_) throw InputError("no channel " + prefix + kNames[c]);
  }
}

bool RgbView::has(const ImageData& image, const std::string& prefix) {
  return std::all_of(kNames.begin(), kNames.end(), [&](const char* name) {
    return offset(image, prefix + name) < image.channels.size();
  });
}

}  // namespace raytracing
