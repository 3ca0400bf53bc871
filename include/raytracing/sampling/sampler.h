#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "raytracing/math/vec.h"

namespace raytracing {

enum class SamplerKind {
  sobol,        ///< Owen-scrambled Sobol' (Burley 2020): pairs 0 and 1 in 4D, the rest 2D
  independent,  ///< pseudo-random numbers
};

std::string_view to_string(SamplerKind kind);
std::optional<SamplerKind> sampler_kind(std::string_view name);

/// The uniform numbers of one sample of one pixel: a pure function of (seed, pixel, sample index,
/// dimension), so that a picture depends neither on threads nor on order. Numbers come in pairs;
/// pairs are made sixteen at a time, which vectorises. All numbers lie in [0,1).
///
/// Replicates of one pixel have scrambles of their own: their means are independent, so that the
/// spread of these tells the error of Sobol' samples, which the spread of the samples does not.
///
/// Pairs 0 and 1 are for the position in the pixel and the first light sample. Direct light is an
/// integral over all four, and only where they are stratified together does its error fall faster
/// than that of 2D pairs padded at random.
class PathSampler {
 public:
  /// `sample` < 2^40 counts within the replicate; `replicate` < 2^24.
  PathSampler(SamplerKind kind, std::uint64_t seed, std::uint32_t x, std::uint32_t y,
              std::uint64_t sample, std::uint64_t replicate = 0);

  /// Pair number `index` of this sample.
  Vec2 pair(std::uint32_t index) {
    if (index - first_ >= kBatch) make_batch(index);
    return {x_[index - first_], y_[index - first_]};
  }

  /// Independent uniform number `i` that belongs to pair `index`: for methods which want more
  /// numbers than a pair, without moving the dimensions of all that follows.
  float extra(std::uint32_t index, std::uint32_t i) const;

  /// A fair coin that belongs to pair `index`: the same for all samples of a pixel (sobol), or
  /// another for each (independent).
  bool coin_of_pixel(std::uint32_t index) const;

 private:
  friend class PixelSampler;
  static constexpr std::uint32_t kBatch = 16;
  struct Key {  // of seed, pixel and replicate; independent: of the sample too
    std::uint32_t low, high;
  };
  struct Scrambles {  // seeds of a batch of pairs
    alignas(64) std::array<std::uint32_t, kBatch> shuffle, x, y;
  };
  static std::uint64_t epoch(SamplerKind kind, std::uint64_t sample, std::uint64_t replicate);
  static Key make_key(std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint64_t epoch);
  static void make_scrambles(const Key& key, std::uint32_t first, Scrambles& scrambles);

  PathSampler(const Key& key, std::uint64_t sample, const Scrambles& scrambles);
  void make_batch(std::uint32_t index);
  void make_sobol(const Scrambles& scrambles);

  SamplerKind kind_;
  Key key_;
  std::uint32_t reversed_sample_;  // bit-reversed low half of the sample index
  std::uint32_t first_ = 0;        // pair held in x_[0], y_[0]
  alignas(64) std::array<float, kBatch> x_;
  alignas(64) std::array<float, kBatch> y_;
};

/// Makes the PathSamplers of one pixel after the other: the same as by their constructor, in less
/// time, since it keeps what the samples of a pixel have in common.
class PixelSampler {
 public:
  PixelSampler(SamplerKind kind, std::uint64_t seed) : kind_(kind), seed_(seed) {}

  PathSampler path(std::uint32_t x, std::uint32_t y, std::uint64_t sample, std::uint64_t replicate);

 private:
  SamplerKind kind_;
  std::uint64_t seed_;
  bool empty_ = true;
  std::uint32_t x_ = 0, y_ = 0;
  std::uint64_t epoch_ = 0;
  PathSampler::Key key_{};
  PathSampler::Scrambles scrambles_;
};

}  // namespace raytracing
