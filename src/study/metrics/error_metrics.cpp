#include "raytracing/study/metrics/error_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

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

}  // namespace raytracing
