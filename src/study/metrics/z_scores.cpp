#include "raytracing/study/metrics/z_scores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "raytracing/io/errors.h"
#include "raytracing/study/metrics/pixels.h"
#include "raytracing/study/metrics/reference.h"
#include "raytracing/study/metrics/statistics.h"

namespace raytracing {
namespace {

bool has_variance(const ImageData& image) { return RgbView::has(image, "variance."); }

// Calls visit(pixel, difference, variance) for each channel of each pixel, in order. The variance
// is that of the difference, and negative where that of either picture is.
template <class Visit>
void for_each_channel(const ImageData& test, const ImageData& reference, const Visit& visit) {
  check_same_size(test, reference);
  const RgbView x(test), r(reference);
  std::array<std::optional<RgbView>, 2> variances;
  if (has_variance(test)) variances[0].emplace(test, "variance.");
  if (has_variance(reference)) variances[1].emplace(reference, "variance.");
  for (std::size_t i = 0; i < x.pixels(); ++i) {
    const DVec3 difference = x[i] - r[i];
    DVec3 variance(0.0);
    for (const auto& view : variances)
      for (int c = 0; view && c < 3; ++c) {
        const double v = (*view)[i][c];
        variance[c] = variance[c] < 0 || v < 0 ? -1 : variance[c] + v;
      }
    for (int c = 0; c < 3; ++c) visit(i, difference[c], variance[c]);
  }
}

bool has_score(double difference, double variance) {
  return std::isfinite(difference) && std::isfinite(variance) && variance > 0;
}

struct Tally {
  ZScores z{};
  double sum = 0, squares = 0;
  std::uint64_t beyond_196 = 0, beyond_3 = 0;

  void add(double difference, double variance) {
    if (has_score(difference, variance)) {
      const double score = difference / std::sqrt(variance);
      ++z.scores;
      sum += score;
      squares += score * score;
      beyond_196 += std::abs(score) > 1.96;
      beyond_3 += std::abs(score) > 3;
    } else if (std::isfinite(difference) && variance == 0) {
      ++(difference == 0 ? z.no_variance_equal : z.no_variance_different);
    } else {
      ++z.not_finite;
    }
  }

  ZScores result() {
    const auto count = static_cast<double>(z.scores);
    z.share_196 = static_cast<double>(beyond_196) / count;
    z.share_3 = static_cast<double>(beyond_3) / count;
    z.mean = sum / count;
    z.rms = std::sqrt(squares / count);
    return z;
  }
};

// The degrees of freedom of the picture's variances; 0 without variance layers or when unknown.
double degrees_of(const ImageData& image) {
  if (!has_variance(image)) return 0;
  const RunFacts facts = facts_of(image.metadata);
  const std::uint64_t replicates = facts.replicates.value_or(1);
  const std::uint64_t samples = replicates > 1 ? replicates : facts.spp.value_or(1);
  return samples > 1 ? static_cast<double>(samples - 1) : 0;
}

bool overstates(const ImageData& image) {
  const RunFacts facts = facts_of(image.metadata);
  return has_variance(image) && facts.sampler == "sobol" && facts.replicates.value_or(1) == 1;
}

}  // namespace

ExpectedScores expected_scores(const ImageData& test, const ImageData& reference) {
  constexpr double kMany = 1000;  // above this, Student's t is treated as normal
  const double degrees = degrees_of(test) + degrees_of(reference);
  const bool normal = degrees < 1 || degrees > kMany;
  const int whole = normal ? static_cast<int>(kMany) : static_cast<int>(degrees);
  ExpectedScores e{};
  e.degrees = normal ? 0 : whole;
  e.share_196 = normal ? std::erfc(1.96 / std::sqrt(2.0)) : 1 - student_t_probability(1.96, whole);
  e.share_3 = normal ? std::erfc(3 / std::sqrt(2.0)) : 1 - student_t_probability(3, whole);
  e.rms = normal ? 1 : whole > 2 ? std::sqrt(whole / (whole - 2.0)) : INFINITY;
  e.overstated = overstates(test) || overstates(reference);
  return e;
}

std::optional<ZScores> z_scores(const ImageData& test, const ImageData& reference,
                                const PixelMask& mask) {
  check_same_size(test, reference);
  check_mask_size(mask, RgbView(test).pixels());
  if (!has_variance(test) && !has_variance(reference)) return std::nullopt;
  Tally tally;
  for_each_channel(test, reference, [&](std::size_t i, double difference, double variance) {
    if (counts(mask, i)) tally.add(difference, variance);
  });
  return tally.result();
}

ImageData z_score_picture(const ImageData& test, const ImageData& reference) {
  check_same_size(test, reference);
  if (!has_variance(test) && !has_variance(reference))
    throw InputError("z-scores: neither picture has variance layers (render --variance)");
  ImageData result{test.width, test.height, {"R", "G", "B"}, {}, {}};
  for_each_channel(test, reference, [&](std::size_t, double difference, double variance) {
    result.values.push_back(has_score(difference, variance)
                                ? static_cast<float>(difference / std::sqrt(variance))
                                : std::numeric_limits<float>::quiet_NaN());
  });
  return result;
}

}  // namespace raytracing
