#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace raytracing {

/// A discrete distribution over n items, sampled by inversion of the cumulative distribution. All
/// probabilities are multiples of 2^-24, the spacing of the uniform random numbers, so that the
/// frequencies are exactly pmf(). An item of positive weight has at least the probability 2^-24, if
/// there are at most 2^24 of them, and its fraction of what remains.
class DiscreteDistribution {
 public:
  DiscreteDistribution() = default;
  /// The weights must be >= 0, with a positive sum unless there are none.
  explicit DiscreteDistribution(std::span<const float> weights);

  struct Choice {
    std::uint32_t index;
    float pmf;
    float u;  ///< the remapped random number, uniform in [0,1) again
  };
  /// Samples an item by a uniform number in [0,1). The distribution must not be empty.
  Choice sample(float u) const { return pmf_.size() == 1 ? Choice{0, 1.0f, u} : sample_many(u); }
  float pmf(std::uint32_t index) const { return pmf_[index]; }
  std::size_t size() const { return pmf_.size(); }

 private:
  Choice sample_many(float u) const;

  std::vector<float> pmf_;
  std::vector<float> cdf_;  // cdf_[i] = sum of pmf_[0..i]; the last is 1
};

}  // namespace raytracing
