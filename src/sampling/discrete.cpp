#include "raytracing/sampling/discrete.h"

#include <algorithm>
#include <numeric>

#include "raytracing/math/numeric.h"

namespace raytracing {

DiscreteDistribution::DiscreteDistribution(std::span<const float> weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  double sum = 0;
  for (float weight : weights) {
    pmf_.push_back(static_cast<float>(weight / total));
    sum += weight;
    cdf_.push_back(static_cast<float>(sum / total));
  }
}

DiscreteDistribution::Choice DiscreteDistribution::sample_many(float u) const {
  const auto it = std::upper_bound(cdf_.begin(), cdf_.end() - 1, u);
  const auto index = static_cast<std::uint32_t>(it - cdf_.begin());
  const float below = index == 0 ? 0.0f : cdf_[index - 1];
  const float rest = (u - below) / (cdf_[index] - below);
  return {index, pmf_[index], std::clamp(rest, 0.0f, kOneMinus)};
}

}  // namespace raytracing
