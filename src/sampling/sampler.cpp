#include "raytracing/sampling/sampler.h"

#include "raytracing/sampling/hash.h"
#include "raytracing/sampling/owen_sobol.h"

namespace raytracing {
namespace {

// Odd constants that tell the streams of one key apart.
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

PathSampler::PathSampler(SamplerKind kind, std::uint64_t seed, std::uint32_t x, std::uint32_t y,
                         std::uint64_t sample, std::uint64_t replicate)
    : kind_(kind), reversed_sample_(reverse_bits(static_cast<std::uint32_t>(sample))) {
  // The sequence has 2^32 points; further samples start another scrambling.
  const std::uint64_t epoch =
      (replicate << 40) + (kind == SamplerKind::sobol ? sample >> 32 : sample);
  std::uint64_t key = mix_bits(seed + 0x9e3779b97f4a7c15u);
  key = mix_bits(key ^ (std::uint64_t{y} << 32 | x));
  key = mix_bits(key + epoch * 0xd1342543de82ef95u);
  key_[0] = static_cast<std::uint32_t>(key);
  key_[1] = static_cast<std::uint32_t>(key >> 32);
  make_batch(0);
}

void PathSampler::make_batch(std::uint32_t index) {
  first_ = index - index % kBatch;
  const std::uint32_t key0 = key_[0], key1 = key_[1], first = first_;
  if (kind_ == SamplerKind::independent) {
    for (std::uint32_t i = 0; i < kBatch; ++i) {
      const std::uint32_t d = first + i;
      x_[i] = unit_float(mix_bits(mix_bits(key0 + d * kScrambleX) ^ key1));
      y_[i] = unit_float(mix_bits(mix_bits(key1 + d * kScrambleY) ^ key0));
    }
    return;
  }
  // The points, bit-reversed, each pair in an order of its own.
  alignas(64) std::uint32_t points_x[kBatch], points_y[kBatch];
  const std::uint32_t reversed = reversed_sample_;
  for (std::uint32_t i = 0; i < kBatch; ++i) {
    const std::uint32_t shuffle = mix_bits(key0 + (first + i) * kShuffle);
    points_x[i] = reverse_bits(scramble_reversed(reversed, shuffle));
    points_y[i] = reversed_sobol2(points_x[i]);
  }
  if (first == 0) {  // pairs 0 and 1 are one point in 4D
    points_x[1] = kSobol3.reversed(points_x[0]);
    points_y[1] = kSobol4.reversed(points_x[0]);
  }
  for (std::uint32_t i = 0; i < kBatch; ++i) {
    const std::uint32_t d = first + i;
    const std::uint32_t seed_x = mix_bits(key1 + d * kScrambleX);
    const std::uint32_t seed_y = mix_bits((key0 ^ key1) + d * kScrambleY);
    x_[i] = unit_float(reverse_bits(scramble_reversed(points_x[i], seed_x)));
    y_[i] = unit_float(reverse_bits(scramble_reversed(points_y[i], seed_y)));
  }
}

bool PathSampler::coin_of_pixel(std::uint32_t index) const {
  return mix_bits((key_[1] ^ kCoin) + index * kExtra) >> 31;
}

float PathSampler::extra(std::uint32_t index, std::uint32_t i) const {
  const std::uint32_t stream = mix_bits(key_[0] + index * kExtra) ^ key_[1];
  const std::uint32_t sample = mix_bits(reversed_sample_ + i * kShuffle);
  return unit_float(mix_bits(mix_bits(stream + sample) + i));
}

}  // namespace raytracing
