#pragma once

#include <cstdint>

namespace raytracing {

/// Reverses the order of 32 bits.
constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}

/// A hash in which each bit of the result depends on that bit and the lower bits of `x` only: on
/// bit-reversed numbers it is a nested uniform (Owen) scrambling (Laine & Karras 2011; Burley 2020,
/// section 3; constants of Vegdahl 2021).
constexpr std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// Bit-reversed second coordinate of the 2D Sobol' sequence at `index`; the first is `index`. Its
/// generator matrix is Pascal's triangle modulo 2, applied in five steps (Ahmed 2024).
constexpr std::uint32_t reversed_sobol2(std::uint32_t index) {
  std::uint32_t y = index;
  y ^= (y >> 16) & 0x0000ffffu;
  y ^= (y & 0xff00ff00u) >> 8;
  y ^= (y & 0xf0f0f0f0u) >> 4;
  y ^= (y & 0xccccccccu) >> 2;
  y ^= (y & 0xaaaaaaaau) >> 1;
  return y;
}

}  // namespace raytracing
