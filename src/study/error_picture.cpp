#include "raytracing/study/error_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "bitmap_font.h"
#include "raytracing/study/rgb_view.h"

namespace raytracing {
namespace {

constexpr Rgb kNotFinite{0, 255, 255};
constexpr Rgb kOutsideMask{96, 96, 96};
constexpr Rgb kBackground{32, 32, 32};
constexpr Rgb kInk{255, 255, 255};
constexpr int kNarrowest = 160;  // where the formula fits

/// Draws with 8-bit sRGB codes.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kBackground) {}

  void set(int x, int y, const Rgb& colour) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(x)] = colour;
  }

  void fill(int x, int y, int width, int height, const Rgb& colour) {
    for (int j = y; j < y + height; ++j)
      for (int i = x; i < x + width; ++i) set(i, j, colour);
  }

  void text(const std::string& text, int left, int top, int scale) {
    for (int y = 0; y < kGlyphHeight * scale; ++y)
      for (int x = 0; x < text_width(text, scale); ++x)
        if (text_pixel(text, x / scale, y / scale)) set(left + x, top + y, kInk);
  }

  static int text_width(const std::string& text, int scale) {
    return static_cast<int>(text.size()) * kGlyphAdvance * scale;
  }

  ImageData image() const {
    ImageData image{width_, height_, {"R", "G", "B"}, {}, {}};
    image.values.reserve(3 * pixels_.size());
    for (const Rgb& p : pixels_)
      for (const float code : {p.x, p.y, p.z})
        image.values.push_back(static_cast<float>(srgb_to_linear(double{code} / 255)));
    return image;
  }

 private:
  int width_, height_;
  std::vector<Rgb> pixels_;
};

/// Sizes of the legend's parts in pixels; `scale` is the size of a dot of the font.
struct Legend {
  int scale, margin, bar, tick, height;

  explicit Legend(int width)
      : scale(std::max(1, (width + 200) / 400)),
        margin(16 * scale),
        bar(10 * scale),
        tick(3 * scale),
        height(bar + 6 * tick + 2 * kGlyphHeight * scale) {}
};

void draw_legend(Canvas& canvas, const Legend& legend, int top, int width,
                 const ErrorScale& scale) {
  const int bar_top = top + legend.tick, bar_width = width - 2 * legend.margin;
  for (int x = 0; x < bar_width; ++x)
    canvas.fill(legend.margin + x, bar_top, 1, legend.bar,
                magma(static_cast<double>(x) / (bar_width - 1)));
  const int tick_top = bar_top + legend.bar, label_top = tick_top + 2 * legend.tick;
  const int decades = scale.high - scale.low;
  const int label_room = Canvas::text_width("1e-10", legend.scale);
  const int step = std::max(1, (label_room * decades + bar_width - 1) / bar_width);
  for (int d = 0; d <= decades; d += step) {
    const int x = legend.margin + (bar_width - 1) * d / decades;
    canvas.fill(x, tick_top, legend.scale, legend.tick, kInk);
    const std::string label = fmt::format("1e{}", scale.low + d);
    canvas.text(label, x - Canvas::text_width(label, legend.scale) / 2, label_top, legend.scale);
  }
  const std::string formula = fmt::format("(x-r)^2/(r^2+{})", kRelMseEpsilon);
  canvas.text(formula, (width - Canvas::text_width(formula, legend.scale)) / 2,
              label_top + kGlyphHeight * legend.scale + 2 * legend.tick, legend.scale);
}

}  // namespace

// matplotlib's "magma" (van der Walt and Smith 2015, CC0) at eleven equal steps; in between it is
// straight to 4 codes.
Rgb magma(double t) {
  static constexpr std::array<Rgb, 11> kSteps{
      Rgb{0, 0, 4},       Rgb{21, 14, 55},    Rgb{59, 15, 112},  Rgb{100, 26, 128},
      Rgb{140, 41, 129},  Rgb{182, 55, 121},  Rgb{222, 73, 104}, Rgb{246, 111, 92},
      Rgb{254, 159, 109}, Rgb{254, 206, 145}, Rgb{252, 253, 191}};
  const double place = std::clamp(t, 0.0, 1.0) * (kSteps.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kSteps.size() - 2);
  const auto rest = static_cast<float>(place - static_cast<double>(below));
  return kSteps[below] * (1 - rest) + kSteps[below + 1] * rest;
}

std::vector<float> relative_squared_errors(const ImageData& test, const ImageData& reference) {
  check_same_size(test, reference);
  const RgbView xs(test), rs(reference);
  std::vector<float> errors;
  errors.reserve(xs.pixels());
  for (std::size_t i = 0; i < xs.pixels(); ++i) {
    const DVec3 difference = xs[i] - rs[i], r = rs[i];
    const DVec3 e = difference * difference / (r * r + kRelMseEpsilon);
    const double error = std::min((e.x + e.y + e.z) / 3, double{std::numeric_limits<float>::max()});
    errors.push_back(is_finite(e) ? static_cast<float>(error)
                                  : std::numeric_limits<float>::quiet_NaN());
  }
  return errors;
}

ImageData error_picture(const ImageData& test, const ImageData& reference, const PixelMask& mask,
                        const ErrorScale& scale) {
  const std::vector<float> errors = relative_squared_errors(test, reference);
  check_mask_size(mask, errors.size());
  const int width = std::max(test.width, kNarrowest);
  const Legend legend(width);
  Canvas canvas(width, test.height + legend.height);
  std::size_t i = 0;
  for (int y = 0; y < test.height; ++y)
    for (int x = 0; x < test.width; ++x, ++i) {
      const double decade = std::log10(double{errors[i]});
      const Rgb colour = magma((decade - scale.low) / (scale.high - scale.low));
      const bool outside = !mask.empty() && mask[i] == 0;
      canvas.set(x, y, outside ? kOutsideMask : std::isfinite(errors[i]) ? colour : kNotFinite);
    }
  draw_legend(canvas, legend, test.height, width, scale);
  return canvas.image();
}

}  // namespace raytracing
