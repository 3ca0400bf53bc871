#include "raytracing/study/z_scores.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "raytracing/io/errors.h"
#include "raytracing/study/power_law.h"
#include "raytracing/study/reference.h"
#include "raytracing/study/rgb_view.h"

namespace raytracing {
namespace {

std::optional<RgbView> variance_of(const ImageData& image) {
  if (!RgbView::has(image, "variance.")) return std::nullopt;
  return RgbView(image, "variance.");
}

// Both pictures and what is known of their variances.
class Scorer {
 public:
  Scorer(const ImageData& test, const ImageData& reference)
      : x_(test),
        r_(reference),
        test_variance_(variance_of(test)),
        reference_variance_(variance_of(reference)) {}

  bool has_variance() const { return test_variance_ || reference_variance_; }
  std::size_t pixels() const { return x_.pixels(); }
  DVec3 difference(std::size_t i) const { return x_[i] - r_[i]; }
  /// Of the difference; negative where either is.
  DVec3 variance(std::size_t i) const {
    const DVec3 x = test_variance_ ? (*test_variance_)[i] : DVec3(0);
    const DVec3 r = reference_variance_ ? (*reference_variance_)[i] : DVec3(0);
    DVec3 sum = x + r;
    for (int c = 0; c < 3; ++c)
      if (x[c] < 0 || r[c] < 0) sum[c] = -1;
    return sum;
  }

 private:
  RgbView x_, r_;
  std::optional<RgbView> test_variance_, reference_variance_;
};

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

// Degrees of freedom of the picture's variances: 0 = no layers, or not known.
double degrees_of(const ImageData& image) {
  if (!RgbView::has(image, "variance.")) return 0;
  const RunFacts facts = facts_of(image.metadata);
  const std::uint64_t replicates = facts.replicates.value_or(1);
  const std::uint64_t samples = replicates > 1 ? replicates : facts.spp.value_or(1);
  return samples > 1 ? static_cast<double>(samples - 1) : 0;
}

bool overstates(const ImageData& image) {
  const RunFacts facts = facts_of(image.metadata);
  return RgbView::has(image, "variance.") && facts.sampler == "sobol" &&
         facts.replicates.value_or(1) == 1;
}

}  // namespace

ExpectedScores expected_scores(const ImageData& test, const ImageData& reference) {
  constexpr double kMany = 1000;  // from here on a normal distribution
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
  const Scorer scorer(test, reference);
  check_mask_size(mask, scorer.pixels());
  if (!scorer.has_variance()) return std::nullopt;
  Tally tally;
  for (std::size_t i = 0; i < scorer.pixels(); ++i) {
    if (!mask.empty() && mask[i] == 0) continue;
    const DVec3 difference = scorer.difference(i), variance = scorer.variance(i);
    for (int c = 0; c < 3; ++c) tally.add(difference[c], variance[c]);
  }
  return tally.result();
}

ImageData z_score_picture(const ImageData& test, const ImageData& reference) {
  check_same_size(test, reference);
  const Scorer scorer(test, reference);
  if (!scorer.has_variance())
    throw InputError("z-scores: neither picture has variance layers (render --variance)");
  ImageData result{test.width, test.height, {"R", "G", "B"}, {}, {}};
  result.values.reserve(3 * scorer.pixels());
  for (std::size_t i = 0; i < scorer.pixels(); ++i) {
    const DVec3 difference = scorer.difference(i), variance = scorer.variance(i);
    for (int c = 0; c < 3; ++c)
      result.values.push_back(has_score(difference[c], variance[c])
                                  ? static_cast<float>(difference[c] / std::sqrt(variance[c]))
                                  : std::numeric_limits<float>::quiet_NaN());
  }
  return result;
}

}  // namespace raytracing
