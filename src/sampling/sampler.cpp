#include "raytracing/sampling/sampler.h"

#include "raytracing/sampling/hash.h"
#include "raytracing/sampling/owen_sobol.h"

namespace raytracing {
namespace {

// Odd constants that separate the random streams of one key.
constexpr std::uint32_t kShuffle = 0x9e3779b9u;
constexpr std::uint32_t kScrambleX = 0x85ebca6bu;
constexpr std::uint32_t kScrambleY = 0xc2b2ae35u;
constexpr std::uint32_t kCoin = 0xd3a2646cu;
constexpr std::uint32_t kExtra = 0x27d4eb2fu;

}  // namespace

std::string_view to_string(SamplerKind kind) {
  return kind == SamplerKind::sobol ? "sobol" : "independent";
}

std::optional<SamplerKind> sampler_kind(std::string_view name) {
  for (SamplerKind kind : {SamplerKind::sobol, SamplerKind::independent})
    if (name == to_string(kind)) return kind;
  return std::nullopt;
}

// The sequence has 2^32 points; further samples use another scrambling.
std::uint64_t PathSampler::epoch(SamplerKind kind, std::uint64_t sample, std::uint64_t replicate) {
  return (replicate << 40) + (kind == SamplerKind::sobol ? sample >> 32 : sample);
}

PathSampler::Key PathSampler::make_key(std::uint64_t seed, std::uint32_t x, std::uint32_t y,
                                       std::uint64_t epoch) {
  std::uint64_t key = mix_bits(seed + 0x9e3779b97f4a7c15u);
  key = mix_bits(key ^ (std::uint64_t{y} << 32 | x));
  key = mix_bits(key + epoch * 0xd1342543de82ef95u);
  return {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)};
}

void PathSampler::make_scrambles(const Key& key, std::uint32_t first, Scrambles& scrambles) {
  const auto [low, high] = key;
  for (std::uint32_t i = 0; i < kBatch; ++i) {
    const std::uint32_t d = first + i;
    scrambles.shuffle[i] = mix_bits(low + d * kShuffle);
    scrambles.x[i] = mix_bits(high + d * kScrambleX);
    scrambles.y[i] = mix_bits((low ^ high) + d * kScrambleY);
  }
}

PathSampler::PathSampler(SamplerKind kind, std::uint64_t seed, std::uint32_t x, std::uint32_t y,
                         std::uint64_t sample, std::uint64_t replicate)
    : kind_(kind),
      key_(make_key(seed, x, y, epoch(kind, sample, replicate))),
      reversed_sample_(reverse_bits(static_cast<std::uint32_t>(sample))) {
  make_batch(0);
}

PathSampler::PathSampler(const Key& key, std::uint64_t sample, const Scrambles& scrambles)
    : kind_(SamplerKind::sobol),
      key_(key),
      reversed_sample_(reverse_bits(static_cast<std::uint32_t>(sample))) {
  make_sobol(scrambles);
}

void PathSampler::make_batch(std::uint32_t index) {
  first_ = index - index % kBatch;
  if (kind_ == SamplerKind::sobol) {
    Scrambles scrambles;
    make_scrambles(key_, first_, scrambles);
    make_sobol(scrambles);
    return;
  }
  const auto [low, high] = key_;
  const std::uint32_t first = first_;
  for (std::uint32_t i = 0; i < kBatch; ++i) {
    const std::uint32_t d = first + i;
    x_[i] = unit_float(mix_bits(mix_bits(low + d * kScrambleX) ^ high));
    y_[i] = unit_float(mix_bits(mix_bits(high + d * kScrambleY) ^ low));
  }
}

void PathSampler::make_sobol(const Scrambles& scrambles) {
  // The points are bit-reversed. Each pair shuffles their order independently.
  alignas(64) std::uint32_t points_x[kBatch], points_y[kBatch];
  const std::uint32_t reversed = reversed_sample_;
  for (std::uint32_t i = 0; i < kBatch; ++i) {
    points_x[i] = reverse_bits(scramble_reversed(reversed, scrambles.shuffle[i]));
    points_y[i] = reversed_sobol2(points_x[i]);
  }
  if (first_ == 0) {  // pairs 0 and 1 form one 4D point
    points_x[1] = kSobol3.reversed(points_x[0]);
    points_y[1] = kSobol4.reversed(points_x[0]);
  }
  for (std::uint32_t i = 0; i < kBatch; ++i) {
    x_[i] = unit_float(reverse_bits(scramble_reversed(points_x[i], scrambles.x[i])));
    y_[i] = unit_float(reverse_bits(scramble_reversed(points_y[i], scrambles.y[i])));
  }
}

PathSampler PixelSampler::path(std::uint32_t x, std::uint32_t y, std::uint64_t sample,
                               std::uint64_t replicate) {
  if (kind_ == SamplerKind::independent) return PathSampler(kind_, seed_, x, y, sample, replicate);
  const std::uint64_t epoch = PathSampler::epoch(kind_, sample, replicate);
  if (empty_ || x != x_ || y != y_ || epoch != epoch_) {
    key_ = PathSampler::make_key(seed_, x, y, epoch);
    PathSampler::make_scrambles(key_, 0, scrambles_);
    empty_ = false;
    x_ = x;
    y_ = y;
    epoch_ = epoch;
  }
  return PathSampler(key_, sample, scrambles_);
}

bool PathSampler::coin_of_pixel(std::uint32_t index) const {
  return mix_bits((key_.high ^ kCoin) + index * kExtra) >> 31;
}

float PathSampler::extra(std::uint32_t index, std::uint32_t i) const {
  const std::uint32_t stream = mix_bits(key_.low + index * kExtra) ^ key_.high;
  const std::uint32_t sample = mix_bits(reversed_sample_ + i * kShuffle);
  return unit_float(mix_bits(mix_bits(stream + sample) + i));
}

}  // namespace raytracing
