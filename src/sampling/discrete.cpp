#include "raytracing/sampling/discrete.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "raytracing/math/numeric.h"

namespace raytracing {
namespace {

// The spacing of the uniform numbers of unit_float(), and their count.
constexpr float kStep = 0x1p-24f;
constexpr double kSteps = 0x1p24;

}  // namespace

// The cumulative sums are whole steps too. Each positive weight gets one step of its own, which
// rounding cannot remove, and its fraction of the remaining steps.
DiscreteDistribution::DiscreteDistribution(std::span<const float> weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const auto positive = static_cast<double>(
      std::count_if(weights.begin(), weights.end(), [](float weight) { return weight > 0; }));
  const double own = positive <= kSteps ? 1 : 0;
  const double shared = kSteps - own * positive;
  double sum = 0, owned = 0;
  float below = 0;
  for (float weight : weights) {
    sum += weight;
    if (weight > 0) owned += own;
    const float border = static_cast<float>(owned + std::round(sum / total * shared)) * kStep;
    pmf_.push_back(border - below);
    cdf_.push_back(border);
    below = border;
  }
}

DiscreteDistribution::Choice DiscreteDistribution::sample_many(float u) const {
  const auto it = std::upper_bound(cdf_.begin(), cdf_.end() - 1, u);
  const auto index = static_cast<std::uint32_t>(it - cdf_.begin());
  const float below = index == 0 ? 0.0f : cdf_[index - 1];
  const float rest = (u - below) / pmf_[index];
  return {index, pmf_[index], std::clamp(rest, 0.0f, kOneMinus)};
}

}  // namespace raytracing
