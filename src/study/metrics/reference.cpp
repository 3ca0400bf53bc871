#include "raytracing/study/metrics/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "raytracing/io/errors.h"
#include "raytracing/io/image.h"
#include "raytracing/study/metrics/overlap.h"

namespace raytracing {
namespace {

std::vector<DVec3> variance_of_halves(const ImageData& picture) {
  const RgbView a(picture, "halfA."), b(picture, "halfB.");
  std::vector<DVec3> variance;
  variance.reserve(a.pixels());
  for (std::size_t i = 0; i < a.pixels(); ++i) {
    const DVec3 half = (a[i] - b[i]) / 2.0;
    variance.push_back(half * half);
  }
  return variance;
}

std::vector<DVec3> variance_layers(const ImageData& picture) {
  const RgbView view(picture, "variance.");
  std::vector<DVec3> variance;
  variance.reserve(view.pixels());
  for (std::size_t i = 0; i < view.pixels(); ++i) variance.push_back(view[i]);
  return variance;
}

bool is_variance(const DVec3& v) { return is_finite(v) && v.x >= 0 && v.y >= 0 && v.z >= 0; }

void expect_equal(const std::string& path, const char* what,
                  const std::optional<std::string>& found, const std::string& wanted) {
  if (!found || found == wanted) return;
  throw InputError(fmt::format("{}: not a reference for this chart: its {} is {}, not {}", path,
                               what, *found, wanted));
}

// The names of those facts that a reference is checked by and its header does not state.
std::string unchecked_facts(const RunFacts& facts) {
  std::string names;
  for (const FactField& field : fact_fields())
    for (const char* name : {"scene_hash", "light_sampling_biased", "max_depth", "complete"})
      if (field.name == name && !fact_value(facts, field))
        names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

// Pictures hold 32-bit floats: a relative bias below this is indistinguishable from rounding.
constexpr double kRounding = 1e-6;

double root(double squared) { return std::sqrt(std::max(0.0, squared)); }

}  // namespace

PixelMask counted_pixels(const ImageData& reference, const PixelMask& mask) {
  const RgbView r(reference);
  check_mask_size(mask, r.pixels());
  PixelMask counted(r.pixels());
  for (std::size_t i = 0; i < counted.size(); ++i) counted[i] = counts(mask, i) && is_finite(r[i]);
  if (std::accumulate(counted.begin(), counted.end(), std::size_t{0}) < 2)
    throw InputError("fewer than two pixels count: mask and finite pixels of the reference");
  return counted;
}

std::optional<NoiseFloor> noise_floor(const Reference& reference, const PixelMask& counted) {
  if (reference.variance.empty()) return std::nullopt;
  const RgbView r(reference.picture);
  const auto& variance = reference.variance;
  return NoiseFloor{
      pixel_mean(counted, [&](std::size_t i) { return mean_of_channels(variance[i]); }),
      pixel_mean(counted, [&](std::size_t i) {
        return mean_of_channels(variance[i] * relative_weight(r[i]));
      })};
}

GroundTruth::GroundTruth(Reference r, const PixelMask& mask)
    : reference(std::move(r)),
      counted(counted_pixels(reference.picture, mask)),
      floor(noise_floor(reference, counted)) {}

ImageData join_halves(const ImageData& a, const ImageData& b) {
  ImageData joined;
  joined.width = a.width;
  joined.height = a.height;
  joined.channels = {"R", "G", "B"};
  for (const char* half : {"halfA.", "halfB."})
    for (const char* channel : {"R", "G", "B"})
      joined.channels.push_back(std::string(half) + channel);
  const RgbView view_a(a), view_b(b);
  joined.values.reserve(9 * view_a.pixels());
  for (std::size_t i = 0; i < view_a.pixels(); ++i)
    for (const DVec3& v : {(view_a[i] + view_b[i]) / 2.0, view_a[i], view_b[i]})
      for (const double c : {v.x, v.y, v.z}) joined.values.push_back(static_cast<float>(c));
  return joined;
}

Reference to_reference(ImageData picture) {
  const RunFacts facts = facts_of(picture.metadata);
  Reference reference{std::move(picture), {}, ""};
  reference.non_finite_samples = facts.non_finite_samples;
  if (RgbView::has(reference.picture, "halfA.") && RgbView::has(reference.picture, "halfB.")) {
    reference.variance = variance_of_halves(reference.picture);
    reference.variance_source = "from two independent halves";
  } else if (!RgbView::has(reference.picture, "variance.")) {
    reference.variance_source = "not known: the file has neither halves nor variance";
  } else if (has_correlated_pixels(facts)) {
    reference.variance_source = "not known: neighbouring pixels share paths; --reuse 1 avoids it";
  } else if (facts.sampler == "independent" || facts.replicates.value_or(1) != 1) {
    reference.variance = variance_layers(reference.picture);
    reference.variance_source = "from the variance layers";
  } else {
    reference.variance_source =
        "not known: the variance layers are neither of independent samples nor of replicates";
  }
  if (!std::all_of(reference.variance.begin(), reference.variance.end(), is_variance)) {
    reference.variance.clear();
    reference.variance_source = "not known: the variance of some pixels is no finite number";
  }
  return reference;
}

Reference read_reference(const std::string& path, const ReferenceTerms& terms) {
  Reference reference = to_reference(read_image(path));
  const ImageData& picture = reference.picture;
  if (picture.integer_bits > 0)
    throw InputError(
        fmt::format("{}: {} bits are too few for a reference; it must hold floats, as "
                    "an EXR file does",
                    path, picture.integer_bits));
  if (picture.whole) throw InputError(path + ": not a reference: only " + pixels_text(picture));
  expect_equal(path, "size", fmt::format("{}x{}", picture.width, picture.height),
               fmt::format("{}x{}", terms.width, terms.height));
  const RunFacts facts = facts_of(picture.metadata);
  expect_equal(path, "scene hash", facts.scene_hash, hash_text(terms.scene_hash));
  if (facts.max_depth)
    expect_equal(path, "maximal depth", to_text(*facts.max_depth), terms.max_depth);
  if (facts.light_sampling_biased == true)
    throw InputError(fmt::format("{}: not a reference: its method {} is biased", path,
                                 facts.light_sampling.value_or("")));
  if (facts.complete == false)
    throw InputError(path + ": not a reference: its rendering was stopped early");
  reference.unchecked = unchecked_facts(facts);
  for (const std::uint64_t other : terms.seeds)
    if (facts.seed == other)
      throw InputError(
          fmt::format("{}: not a reference: its seed {} is that of a test run", path, other));
  return reference;
}

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
