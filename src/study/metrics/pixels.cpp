#include "raytracing/study/metrics/pixels.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "raytracing/io/errors.h"
#include "raytracing/io/image.h"
#include "raytracing/study/metrics/overlap.h"

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

PixelMask to_mask(const ImageData& mask) {
  const RgbView view(mask);
  PixelMask result(view.pixels());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = mean_of_channels(view[i]) >= 0.5;
  return result;
}

PixelMask read_mask(const std::string& path, int width, int height, const PixelWindow& pixels,
                    std::vector<std::string>& notes) {
  if (path.empty()) return {};
  const ImageData mask = read_image(path);
  if (mask.whole || mask.width != width || mask.height != height)
    throw InputError(
        fmt::format("{}: {}, but the pictures have {}x{}", path, pixels_text(mask), width, height));
  for (const std::string& note : mask.notes) notes.push_back("note: " + path + ": " + note);
  PixelMask result = to_mask(cropped(mask, pixels));
  if (std::find(result.begin(), result.end(), 1) == result.end())
    throw InputError(path + ": no pixel of the mask is white, so that none would count");
  return result;
}

void check_same_size(const ImageData& test, const ImageData& reference) {
  if (test.width != reference.width || test.height != reference.height)
    throw InputError(fmt::format("different sizes: {}x{} and {}x{} pixels", test.width, test.height,
                                 reference.width, reference.height));
}

void check_mask_size(const PixelMask& mask, std::size_t pixels) {
  if (!mask.empty() && mask.size() != pixels)
    throw InputError("the mask is not of the pictures' size");
}

double masked_mean(const std::vector<float>& values, const PixelMask& mask) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!counts(mask, i)) continue;
    sum += double{values[i]};
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace raytracing
