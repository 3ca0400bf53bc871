#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "raytracing/math/vec.h"

namespace raytracing {

enum class SamplerKind {
  sobol,        ///< Owen-scrambled Sobol' points (Burley 2020): pairs 0 and 1 in 4D, others in 2D
  independent,  ///< independent pseudo-random numbers
};

std::string_view to_string(SamplerKind kind);
/// Returns the kind of this name, or nothing.
std::optional<SamplerKind> sampler_kind(std::string_view name);

/// The largest sample count of a pixel.
inline constexpr std::uint64_t kMaxSpp = std::uint64_t{1} << 40;

/// The uniform random numbers of one sample of one pixel. They are a pure function of seed, pixel,
/// sample index and dimension, so that a picture depends neither on the number of threads nor on
/// their order. The numbers lie in [0,1) and come in pairs, which are generated in vectorised
/// batches of sixteen.
///
/// Replicates of a pixel are scrambled independently. The variance of their means therefore
/// estimates the error of Sobol' samples, which the variance of the samples does not.
///
/// Pairs 0 and 1 are meant for the position in the pixel and the first light sample. Direct
/// illumination is an integral over these four dimensions. Its error falls faster than with
/// randomly padded 2D pairs only if the four are stratified jointly.
class PathSampler {
 public:
  /// The index `sample` < kMaxSpp counts within the replicate; `replicate` must be < 2^24.
  PathSampler(SamplerKind kind, std::uint64_t seed, std::uint32_t x, std::uint32_t y,
              std::uint64_t sample, std::uint64_t replicate = 0);

  /// Returns pair `index` of this sample.
  Vec2 pair(std::uint32_t index) {
    if (index - first_ >= kBatch) make_batch(index);
    return {x_[index - first_], y_[index - first_]};
  }

  /// Returns the independent uniform number `i` that belongs to pair `index`. Methods that need
  /// more numbers than a pair use it without shifting the later dimensions.
  float extra(std::uint32_t index, std::uint32_t i) const;

  /// Returns a fair coin flip that belongs to pair `index`. It is the same for all samples of a
  /// pixel (sobol), or independent for each (independent).
  bool coin_of_pixel(std::uint32_t index) const;

 private:
  friend class PixelSampler;
  static constexpr std::uint32_t kBatch = 16;
  struct Key {  // hash of seed, pixel and replicate; for independent numbers, of the sample too
    std::uint32_t low, high;
  };
  struct Scrambles {  // scrambling seeds of a batch of pairs
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
  std::uint32_t reversed_sample_;  // bit-reversed low 32 bits of the sample index
  std::uint32_t first_ = 0;        // index of the pair in x_[0], y_[0]
  alignas(64) std::array<float, kBatch> x_;
  alignas(64) std::array<float, kBatch> y_;
};

/// Makes the PathSamplers of the samples of a pixel. They equal those of the constructor but take
/// less time, because the scrambling seeds of a pixel are computed once.
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
