#pragma once
// Eight floats, and eight points, for the traversals of the OccluderTree.

#include <experimental/simd>

#include "raytracing/math/vec.h"

namespace raytracing {

namespace simd = std::experimental;
inline constexpr int kLanes = 8;
using Float8 = simd::simd<float, simd::simd_abi::deduce_t<float, kLanes>>;
using Mask8 = Float8::mask_type;

/// Loads 8 values, which must be aligned to 32 bytes.
inline Float8 load(const float* values) { return Float8(values, simd::vector_aligned); }

inline unsigned to_bits(const Mask8& mask) {
  unsigned bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= static_cast<unsigned>(mask[i]) << i;
  return bits;
}

[[gnu::always_inline]] inline Float8 select(const Mask8& mask, const Float8& yes,
                                            const Float8& no) {
  Float8 result = no;
  simd::where(mask, result) = yes;
  return result;
}

/// Eight points or directions.
struct Points {
  Float8 x, y, z;
};

[[gnu::always_inline]] inline Points select(const Mask8& mask, const Points& yes,
                                            const Points& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

}  // namespace raytracing
