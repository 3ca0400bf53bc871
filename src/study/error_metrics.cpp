#include "raytracing/study/error_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "raytracing/io/errors.h"
#include "raytracing/io/image_reader.h"
#include "raytracing/study/rgb_view.h"

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

}  // namespace

void check_same_size(const ImageData& test, const ImageData& reference) {
  if (test.width != reference.width || test.height != reference.height)
    throw InputError(fmt::format("different sizes: {}x{} and {}x{} pixels", test.width, test.height,
                                 reference.width, reference.height));
}

void check_mask_size(const PixelMask& mask, std::size_t pixels) {
  if (!mask.empty() && mask.size() != pixels)
    throw InputError("the mask is not of the pictures' size");
}

ErrorMetrics error_metrics(const ImageData& test, const ImageData& reference,
                           const PixelMask& mask) {
  check_same_size(test, reference);
  const RgbView xs(test), rs(reference);
  check_mask_size(mask, xs.pixels());
  ErrorMetrics m{};
  m.largest_x = m.largest_y = -1;
  Sums sums;
  for (std::size_t i = 0; i < xs.pixels(); ++i) {
    if (!mask.empty() && mask[i] == 0) continue;
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

PixelMask read_mask(const std::string& path, int width, int height) {
  if (path.empty()) return {};
  const ImageData mask = read_image(path);
  if (mask.width != width || mask.height != height)
    throw InputError(fmt::format("{}: {}x{} pixels, but the pictures have {}x{}", path, mask.width,
                                 mask.height, width, height));
  PixelMask result = to_mask(mask);
  if (std::find(result.begin(), result.end(), 1) == result.end())
    throw InputError(path + ": no pixel of the mask is white, so that none would count");
  return result;
}

std::string relmse_formula() { return fmt::format("mean of (x-r)^2 / (r^2 + {})", kRelMseEpsilon); }

PixelMask to_mask(const ImageData& mask) {
  const RgbView view(mask);
  PixelMask result(view.pixels());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const DVec3 v = view[i];
    result[i] = (v.x + v.y + v.z) / 3 >= 0.5;
  }
  return result;
}

}  // namespace raytracing
