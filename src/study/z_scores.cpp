#include "raytracing/study/z_scores.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "raytracing/study/power_law.h"
#include "raytracing/study/reference.h"
#include "raytracing/study/rgb_view.h"

namespace raytracing {
namespace {

std::optional<RgbView> variance_of(const ImageData& image) {
  if (!RgbView::has(image, "variance.")) return std::nullopt;
  return RgbView(image, "variance.");
}

struct Tally {
  ZScores z{};
  double sum = 0, squares = 0;
  std::uint64_t beyond_196 = 0, beyond_3 = 0;

  void add(double difference, double variance) {
    if (!std::isfinite(difference) || !std::isfinite(variance) || variance < 0) {
      ++z.not_finite;
    } else if (variance == 0) {
      ++(difference == 0 ? z.no_variance_equal : z.no_variance_different);
    } else {
      const double score = difference / std::sqrt(variance);
      ++z.scores;
      sum += score;
      squares += score * score;
      beyond_196 += std::abs(score) > 1.96;
      beyond_3 += std::abs(score) > 3;
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
  const double replicates = std::atof(header_text(image, "replicates").c_str());
  const double spp = std::atof(header_text(image, "spp").c_str());
  return std::max(0.0, (replicates > 1 ? replicates : spp) - 1);
}

bool overstates(const ImageData& image) {
  const std::string replicates = header_text(image, "replicates");
  return RgbView::has(image, "variance.") && header_text(image, "sampler") == "sobol" &&
         (replicates.empty() || replicates == "1");
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
  const RgbView xs(test), rs(reference);
  check_mask_size(mask, xs.pixels());
  const std::optional<RgbView> test_variance = variance_of(test);
  const std::optional<RgbView> reference_variance = variance_of(reference);
  if (!test_variance && !reference_variance) return std::nullopt;
  Tally tally;
  for (std::size_t i = 0; i < xs.pixels(); ++i) {
    if (!mask.empty() && mask[i] == 0) continue;
    const DVec3 x = xs[i], r = rs[i];
    const DVec3 var_x = test_variance ? (*test_variance)[i] : DVec3(0);
    const DVec3 var_r = reference_variance ? (*reference_variance)[i] : DVec3(0);
    for (int c = 0; c < 3; ++c) {
      const bool negative = var_x[c] < 0 || var_r[c] < 0;
      tally.add(x[c] - r[c], negative ? -1 : var_x[c] + var_r[c]);
    }
  }
  return tally.result();
}

}  // namespace raytracing
