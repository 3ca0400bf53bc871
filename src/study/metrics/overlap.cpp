#include "raytracing/study/metrics/overlap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace raytracing {

PixelWindow whole_of(const ImageData& image) {
  return image.whole.value_or(PixelWindow{0, 0, image.width, image.height});
}

PixelWindow window_of(const ImageData& image) {
  const PixelWindow whole = whole_of(image);
  return {-whole.x, -whole.y, image.width, image.height};
}

ImageData cropped(const ImageData& image, const PixelWindow& window) {
  const PixelWindow own = window_of(image), whole = whole_of(image);
  if (window == own) return image;
  ImageData result;
  result.width = window.width;
  result.height = window.height;
  result.channels = image.channels;
  result.metadata = image.metadata;
  result.integer_bits = image.integer_bits;
  result.whole = PixelWindow{-window.x, -window.y, whole.width, whole.height};
  result.notes = image.notes;
  const std::size_t stride = image.channels.size();
  const std::size_t row = stride * static_cast<std::size_t>(image.width);
  for (int y = 0; y < window.height; ++y) {
    const auto first =
        image.values.begin() +
        static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(window.y - own.y + y) +
                                    stride * static_cast<std::size_t>(window.x - own.x));
    result.values.insert(
        result.values.end(), first,
        first + static_cast<std::ptrdiff_t>(stride * static_cast<std::size_t>(window.width)));
  }
  return result;
}

std::optional<PixelWindow> common_window(const ImageData& a, const ImageData& b) {
  const PixelWindow whole_a = whole_of(a), whole_b = whole_of(b);
  const PixelWindow x = window_of(a), y = window_of(b);
  const int left = std::max(x.x, y.x), top = std::max(x.y, y.y);
  const PixelWindow common{left, top, std::min(x.x + x.width, y.x + y.width) - left,
                           std::min(x.y + x.height, y.y + y.height) - top};
  if (whole_a.width != whole_b.width || whole_a.height != whole_b.height || common.width < 1 ||
      common.height < 1)
    return {};
  return common;
}

std::string pixels_text(const ImageData& image) {
  std::string size = fmt::format("{}x{} pixels", image.width, image.height);
  if (!image.whole) return size;
  const PixelWindow window = window_of(image);
  return fmt::format("{} at {},{} of {}x{}", size, window.x, window.y, image.whole->width,
                     image.whole->height);
}

}  // namespace raytracing
