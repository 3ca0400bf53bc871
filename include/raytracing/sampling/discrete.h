#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace raytracing {

/// Choice among n things with given probabilities, by inversion of the cumulative sum. The
/// probabilities are whole steps of the uniform numbers, 2^-24, so that choices are made exactly as
/// often as told: each positive weight has at least one (where there are not more than 2^24), and
/// its share of all others.
class DiscreteDistribution {
 public:
  DiscreteDistribution() = default;
  /// Weights >= 0, not all zero unless there are none.
  explicit DiscreteDistribution(std::span<const float> weights);

  struct Choice {
    std::uint32_t index;
    float pmf;
    float u;  ///< what is left of the uniform number: uniform in [0,1) again
  };
  /// Chooses by a uniform number in [0,1). The distribution must not be empty.
  Choice sample(float u) const { return pmf_.size() == 1 ? Choice{0, 1.0f, u} : sample_many(u); }
  float pmf(std::uint32_t index) const { return pmf_[index]; }
  std::size_t size() const { return pmf_.size(); }

 private:
  Choice sample_many(float u) const;

  std::vector<float> pmf_;
  std::vector<float> cdf_;  // cdf_[i] = sum of pmf_[0..i]; the last is 1
};

}  // namespace raytracing
