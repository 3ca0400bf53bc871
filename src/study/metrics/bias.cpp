#include "raytracing/study/metrics/bias.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "raytracing/study/metrics/pixels.h"

namespace raytracing {
namespace {

// Pictures hold 32-bit floats: a relative bias below this is indistinguishable from rounding.
constexpr double kRounding = 1e-6;

double root(double squared) { return std::sqrt(std::max(0.0, squared)); }

}  // namespace

void SeedMoments::add(const ImageData& picture) {
  const RgbView view(picture);
  if (count_ == 0) {
    mean_.assign(view.pixels(), DVec3(0.0));
    squares_ = mean_;
  }
  ++count_;
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    const DVec3 x = view[i];
    const DVec3 delta = x - mean_[i];
    mean_[i] += delta / static_cast<double>(count_);
    squares_[i] += delta * (x - mean_[i]);
  }
}

DVec3 SeedMoments::variance_of_mean(std::size_t pixel) const {
  return squares_[pixel] / (static_cast<double>(count_) * (count_ - 1));
}

double BiasEstimate::rms() const { return root(squared.value); }
double BiasEstimate::rms_low() const {
  return root(squared.value - kNormal95 * squared.standard_error);
}
double BiasEstimate::rms_high() const {
  return root(squared.value + kNormal95 * squared.standard_error);
}

std::string to_text(const BiasEstimate& bias) {
  const double half = kNormal95 * bias.relative_squared.standard_error;
  const std::string mean = fmt::format("mean {:+.2f} % ± {:.2f} %", 100 * bias.mean_ratio.value,
                                       100 * kNormal95 * bias.mean_ratio.standard_error);
  if (bias.detected)
    return fmt::format("BIASED: relMSE levels off at {:.2g} ± {:.1g}; {}",
                       std::max(0.0, bias.relative_squared.value), half, mean);
  return fmt::format("bias not distinguishable from 0: relMSE levels off below {:.2g}; {}",
                     std::max(0.0, bias.relative_squared.value) + half, mean);
}

std::optional<BiasEstimate> estimate_bias(const SeedMoments& moments, const Reference& reference,
                                          const PixelMask& counted) {
  if (moments.count() < 2 || reference.variance.empty()) return std::nullopt;
  const RgbView r(reference.picture);
  const auto difference = [&](std::size_t i) { return moments.mean()[i] - r[i]; };
  const auto squared_bias = [&](std::size_t i) {
    const DVec3 d = difference(i);
    return d * d - moments.variance_of_mean(i) - reference.variance[i];
  };
  BiasEstimate bias;
  bias.squared =
      pixel_mean(counted, [&](std::size_t i) { return mean_of_channels(squared_bias(i)); });
  bias.relative_squared = pixel_mean(counted, [&](std::size_t i) {
    return mean_of_channels(squared_bias(i) * relative_weight(r[i]));
  });
  const Estimate d =
      pixel_mean(counted, [&](std::size_t i) { return mean_of_channels(difference(i)); });
  const double mean =
      pixel_mean(counted, [&](std::size_t i) { return mean_of_channels(r[i]); }).value;
  if (mean > 0) bias.mean_ratio = {d.value / mean, d.standard_error / mean};
  bias.detected =
      bias.relative_squared.value >
          kOneSidedHalfPercent * bias.relative_squared.standard_error + kRounding * kRounding ||
      std::abs(bias.mean_ratio.value) >
          kTwoSidedHalfPercent * bias.mean_ratio.standard_error + kRounding;
  return bias;
}

}  // namespace raytracing
