#include "raytracing/study/metrics/error_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "raytracing/io/image_library.h"
#include "raytracing/study/metrics/error_metrics.h"

namespace raytracing {
namespace {

constexpr int kLowDecade = -5, kHighDecade = 1;  // the ends of the colour bar
const Rgb kNotFinite{0, 1, 1};
const Rgb kOutsideMask{0.117f};
const Rgb kBackground{0.0144f};
const Rgb kInk{1};
constexpr int kMinWidth = 160;  // room for the formula

/// A picture to draw on, in linear colours.
class Canvas {
 public:
  Canvas(int width, int height) {
    image_.width = width;
    image_.height = height;
    image_.channels = {"R", "G", "B"};
    image_.values.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    fill(0, 0, width, height, kBackground);
  }

  void set(int x, int y, const Rgb& colour) {
    float* pixel = image_.values.data() +
                   3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                        static_cast<std::size_t>(x));
    for (int c = 0; c < 3; ++c) pixel[c] = colour[c];
  }

  void fill(int x, int y, int width, int height, const Rgb& colour) {
    for (int j = y; j < y + height; ++j)
      for (int i = x; i < x + width; ++i) set(i, j, colour);
  }

  ImageData& image() { return image_; }

 private:
  ImageData image_;
};

Rgb colour_at(const std::vector<float>& colours, std::size_t index) {
  return {colours[3 * index], colours[3 * index + 1], colours[3 * index + 2]};
}

/// Sizes of the legend's parts in pixels; `scale` follows the width of the picture.
struct Legend {
  int scale, margin, bar, tick, font, height;

  explicit Legend(int width)
      : scale(std::max(1, (width + 200) / 400)),
        margin(16 * scale),
        bar(10 * scale),
        tick(3 * scale),
        font(11 * scale),
        height(bar + 5 * tick + 2 * font) {}

  /// Decades between labels, so that they have room.
  int step(int bar_width) const {
    const int label_room = 3 * font, decades = kHighDecade - kLowDecade;
    return std::max(1, (label_room * decades + bar_width - 1) / bar_width);
  }
};

void draw_legend(Canvas& canvas, const Legend& legend, int top, int width) {
  const int bar_top = top + legend.tick, bar_width = width - 2 * legend.margin;
  std::vector<float> places;
  for (int x = 0; x < bar_width; ++x)
    places.push_back(static_cast<float>(x) / static_cast<float>(bar_width - 1));
  const std::vector<float> colours = image_library().magma(places);
  for (int x = 0; x < bar_width; ++x)
    canvas.fill(legend.margin + x, bar_top, 1, legend.bar,
                colour_at(colours, static_cast<std::size_t>(x)));
  const int tick_top = bar_top + legend.bar, label_top = tick_top + 2 * legend.tick;
  const int decades = kHighDecade - kLowDecade;
  std::vector<TextLabel> labels;
  for (int d = 0; d <= decades; d += legend.step(bar_width)) {
    const int x = legend.margin + (bar_width - 1) * d / decades;
    canvas.fill(x, tick_top, legend.scale, legend.tick, kInk);
    labels.push_back({fmt::format("1e{}", kLowDecade + d), x, label_top, legend.font});
  }
  labels.push_back({fmt::format("(x-r)^2 / (r^2+{})", kRelMseEpsilon), width / 2,
                    label_top + legend.font + legend.tick, legend.font});
  image_library().draw_labels(canvas.image(), labels);
}

void draw_errors(Canvas& canvas, const ImageData& test, const ImageData& reference,
                 const PixelMask& mask) {
  const std::vector<float> errors = relative_squared_errors(test, reference);
  check_mask_size(mask, errors.size());
  std::vector<float> places;
  places.reserve(errors.size());
  for (const float error : errors) {
    const double place = (std::log10(double{error}) - kLowDecade) / (kHighDecade - kLowDecade);
    places.push_back(static_cast<float>(std::isnan(place) ? 0 : std::clamp(place, 0.0, 1.0)));
  }
  const std::vector<float> colours = image_library().magma(places);
  std::size_t i = 0;
  for (int y = 0; y < test.height; ++y)
    for (int x = 0; x < test.width; ++x, ++i) {
      const Rgb colour = std::isfinite(errors[i]) ? colour_at(colours, i) : kNotFinite;
      canvas.set(x, y, counts(mask, i) ? colour : kOutsideMask);
    }
}

}  // namespace

std::string error_colours() {
  return fmt::format("black (1e{} and less) over red to light yellow (1e{} and more)", kLowDecade,
                     kHighDecade);
}

ImageData error_map(const ImageData& test, const ImageData& reference, const PixelMask& mask) {
  Canvas canvas(test.width, test.height);
  draw_errors(canvas, test, reference, mask);
  return canvas.image();
}

ImageData error_picture(const ImageData& test, const ImageData& reference, const PixelMask& mask) {
  const int width = std::max(test.width, kMinWidth);
  const Legend legend(width);
  Canvas canvas(width, test.height + legend.height);
  draw_errors(canvas, test, reference, mask);
  draw_legend(canvas, legend, test.height, width);
  return canvas.image();
}

}  // namespace raytracing
