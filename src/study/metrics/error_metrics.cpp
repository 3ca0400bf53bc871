#include "raytracing/study/metrics/error_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "raytracing/io/srgb.h"

namespace raytracing {
namespace {

struct Sums {
  double squared = 0, relative = 0, absolute = 0, symmetric = 0;
  DVec3 test{0}, reference{0};

  void add(const DVec3& x, const DVec3& r) {
    for (int c = 0; c < 3; ++c) {
      const double difference = std::abs(x[c] - r[c]);
      const double square = difference * difference;
      squared += square;
      relative += square / (r[c] * r[c] + kRelMseEpsilon);
      absolute += difference;
      symmetric += difference / (std::abs(x[c]) + std::abs(r[c]) + kRelMseEpsilon);
    }
    test += x;
    reference += r;
  }
};

constexpr int kLowDecade = -5, kHighDecade = 1;  // the ends of the colour bar
constexpr Rgb kNotFinite{0, 255, 255};
constexpr Rgb kOutsideMask{96, 96, 96};
constexpr Rgb kBackground{32, 32, 32};
constexpr Rgb kInk{255, 255, 255};
constexpr int kMinWidth = 160;  // room for the formula

constexpr int kGlyphWidth = 5, kGlyphHeight = 7, kGlyphAdvance = 6;

// A character of the legend: one byte a row, top row first; the leftmost column is bit 4.
struct Glyph {
  char character;
  std::array<std::uint8_t, kGlyphHeight> rows;
};

constexpr std::array kGlyphs{
    Glyph{'0', {0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110}},
    Glyph{'1', {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    Glyph{'2', {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111}},
    Glyph{'3', {0b01110, 0b10001, 0b00001, 0b00110, 0b00001, 0b10001, 0b01110}},
    Glyph{'4', {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010}},
    Glyph{'5', {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110}},
    Glyph{'6', {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110}},
    Glyph{'7', {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000}},
    Glyph{'8', {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110}},
    Glyph{'9', {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100}},
    Glyph{'e', {0b00000, 0b00000, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110}},
    Glyph{'r', {0b00000, 0b00000, 0b10110, 0b11001, 0b10000, 0b10000, 0b10000}},
    Glyph{'x', {0b00000, 0b00000, 0b10001, 0b01010, 0b00100, 0b01010, 0b10001}},
    Glyph{'-', {0b00000, 0b00000, 0b00000, 0b11111, 0b00000, 0b00000, 0b00000}},
    Glyph{'+', {0b00000, 0b00100, 0b00100, 0b11111, 0b00100, 0b00100, 0b00000}},
    Glyph{'/', {0b00001, 0b00001, 0b00010, 0b00100, 0b01000, 0b10000, 0b10000}},
    Glyph{'^', {0b00100, 0b01010, 0b10001, 0b00000, 0b00000, 0b00000, 0b00000}},
    Glyph{'.', {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b01100, 0b01100}},
    Glyph{'(', {0b00010, 0b00100, 0b01000, 0b01000, 0b01000, 0b00100, 0b00010}},
    Glyph{')', {0b01000, 0b00100, 0b00010, 0b00010, 0b00010, 0b00100, 0b01000}},
};

// Whether the pixel (x, y) of a line of text is set; y counts down, x from the left end of the
// text. Characters without a glyph are blank.
bool text_pixel(std::string_view text, int x, int y) {
  const int column = x % kGlyphAdvance, index = x / kGlyphAdvance;
  if (x < 0 || y < 0 || y >= kGlyphHeight || column >= kGlyphWidth ||
      index >= static_cast<int>(text.size()))
    return false;
  const char character = text[static_cast<std::size_t>(index)];
  const auto glyph = std::find_if(kGlyphs.begin(), kGlyphs.end(),
                                  [=](const Glyph& g) { return g.character == character; });
  if (glyph == kGlyphs.end()) return false;
  return (glyph->rows[static_cast<std::size_t>(y)] >> (kGlyphWidth - 1 - column) & 1) != 0;
}

/// A picture of 8-bit sRGB codes to draw on.
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

void draw_legend(Canvas& canvas, const Legend& legend, int top, int width) {
  const int bar_top = top + legend.tick, bar_width = width - 2 * legend.margin;
  for (int x = 0; x < bar_width; ++x)
    canvas.fill(legend.margin + x, bar_top, 1, legend.bar,
                magma(static_cast<double>(x) / (bar_width - 1)));
  const int tick_top = bar_top + legend.bar, label_top = tick_top + 2 * legend.tick;
  const int decades = kHighDecade - kLowDecade;
  const int label_room = Canvas::text_width("1e-10", legend.scale);
  const int step = std::max(1, (label_room * decades + bar_width - 1) / bar_width);
  for (int d = 0; d <= decades; d += step) {
    const int x = legend.margin + (bar_width - 1) * d / decades;
    canvas.fill(x, tick_top, legend.scale, legend.tick, kInk);
    const std::string label = fmt::format("1e{}", kLowDecade + d);
    canvas.text(label, x - Canvas::text_width(label, legend.scale) / 2, label_top, legend.scale);
  }
  const std::string formula = fmt::format("(x-r)^2/(r^2+{})", kRelMseEpsilon);
  canvas.text(formula, (width - Canvas::text_width(formula, legend.scale)) / 2,
              label_top + kGlyphHeight * legend.scale + 2 * legend.tick, legend.scale);
}

void draw_errors(Canvas& canvas, const ImageData& test, const ImageData& reference,
                 const PixelMask& mask) {
  const std::vector<float> errors = relative_squared_errors(test, reference);
  check_mask_size(mask, errors.size());
  std::size_t i = 0;
  for (int y = 0; y < test.height; ++y)
    for (int x = 0; x < test.width; ++x, ++i) {
      const double decade = std::log10(double{errors[i]});
      const Rgb colour = magma((decade - kLowDecade) / (kHighDecade - kLowDecade));
      const bool inside = counts(mask, i);
      canvas.set(x, y, !inside ? kOutsideMask : std::isfinite(errors[i]) ? colour : kNotFinite);
    }
}

}  // namespace

ErrorMetrics error_metrics(const ImageData& test, const ImageData& reference,
                           const PixelMask& mask) {
  check_same_size(test, reference);
  const RgbView xs(test), rs(reference);
  check_mask_size(mask, xs.pixels());
  ErrorMetrics m{};
  m.largest_x = m.largest_y = -1;
  Sums sums;
  for (std::size_t i = 0; i < xs.pixels(); ++i) {
    if (!counts(mask, i)) continue;
    const DVec3 x = xs[i], r = rs[i];
    const bool finite_test = is_finite(x), finite_reference = is_finite(r);
    m.non_finite_test += !finite_test;
    m.non_finite_reference += !finite_reference;
    if (!finite_test || !finite_reference) continue;
    ++m.pixels;
    sums.add(x, r);
    const DVec3 difference = glm::abs(x - r);
    const double largest = glm::max(difference.x, glm::max(difference.y, difference.z));
    if (m.largest_x >= 0 && largest <= m.largest) continue;
    m.largest = largest;
    m.largest_x = static_cast<int>(i % static_cast<std::size_t>(test.width));
    m.largest_y = static_cast<int>(i / static_cast<std::size_t>(test.width));
  }
  const double count = 3 * static_cast<double>(m.pixels);
  m.mse = sums.squared / count;
  m.rmse = std::sqrt(m.mse);
  m.relmse = sums.relative / count;
  m.mae = sums.absolute / count;
  m.psnr = -10 * std::log10(m.mse);
  m.smape = sums.symmetric / count;
  m.mean_ratio = sums.test / sums.reference;
  return m;
}

std::string relmse_formula() { return fmt::format("mean of (x-r)^2 / (r^2 + {})", kRelMseEpsilon); }

DVec3 relative_weight(const DVec3& r) { return 1.0 / (r * r + kRelMseEpsilon); }

std::vector<float> relative_squared_errors(const ImageData& test, const ImageData& reference) {
  check_same_size(test, reference);
  const RgbView xs(test), rs(reference);
  std::vector<float> errors;
  errors.reserve(xs.pixels());
  for (std::size_t i = 0; i < xs.pixels(); ++i) {
    const DVec3 difference = xs[i] - rs[i], r = rs[i];
    const DVec3 e = difference * difference / (r * r + kRelMseEpsilon);
    const double error = std::min(mean_of_channels(e), double{std::numeric_limits<float>::max()});
    errors.push_back(is_finite(e) ? static_cast<float>(error)
                                  : std::numeric_limits<float>::quiet_NaN());
  }
  return errors;
}

// The table holds matplotlib's "magma" (van der Walt and Smith 2015, CC0) at eleven equal steps;
// linear interpolation between them is exact to 4 codes.
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
