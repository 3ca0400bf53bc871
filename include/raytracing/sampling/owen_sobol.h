#pragma once
// Points of the Sobol' sequence and their Owen scrambling, on bit-reversed integers.

#include <array>
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

/// Scrambles a bit-reversed number by nested uniform (Owen) scrambling: a hash in which each bit of
/// the result depends only on that bit and the lower bits of `x` (Laine & Karras 2011; Burley 2020,
/// section 3; constants of Vegdahl 2021).
constexpr std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// Returns the bit-reversed second coordinate of the 2D Sobol' sequence at `index`. The first
/// bit-reversed coordinate is `index` itself. The generator matrix is Pascal's triangle modulo 2,
/// applied in five steps (Ahmed 2024).
constexpr std::uint32_t reversed_sobol2(std::uint32_t index) {
  std::uint32_t y = index;
  y ^= (y >> 16) & 0x0000ffffu;
  y ^= (y & 0xff00ff00u) >> 8;
  y ^= (y & 0xf0f0f0f0u) >> 4;
  y ^= (y & 0xccccccccu) >> 2;
  y ^= (y & 0xaaaaaaaau) >> 1;
  return y;
}

/// A higher coordinate of the Sobol' sequence, bit-reversed, from one table for each byte of the
/// index.
class SobolCoordinate {
 public:
  /// Builds the tables from the primitive polynomial x^degree + a_1 x^(degree-1) + ... + 1 and the
  /// first `degree` direction numbers (Joe & Kuo 2008, eqs. 2 and 3). The bits of `a` are the inner
  /// coefficients; a_1 is the highest.
  constexpr SobolCoordinate(int degree, std::uint32_t a,
                            const std::array<std::uint32_t, 3>& first) {
    std::array<std::uint32_t, 32> m{};
    for (int i = 0; i < 32; ++i) {
      if (i < degree) {
        m[i] = first[i];
        continue;
      }
      m[i] = m[i - degree] ^ (m[i - degree] << degree);
      for (int k = 1; k < degree; ++k)
        if ((a >> (degree - 1 - k)) & 1) m[i] ^= m[i - k] << k;
    }
    for (int bit = 0; bit < 32; ++bit) {
      const std::uint32_t reversed = reverse_bits(m[bit] << (31 - bit));
      auto& table = tables_[bit / 8];
      for (std::uint32_t byte = 0; byte < 256; ++byte)
        if ((byte >> (bit % 8)) & 1) table[byte] ^= reversed;
    }
  }

  constexpr std::uint32_t reversed(std::uint32_t index) const {
    return tables_[0][index & 255] ^ tables_[1][(index >> 8) & 255] ^
           tables_[2][(index >> 16) & 255] ^ tables_[3][index >> 24];
  }

 private:
  std::array<std::array<std::uint32_t, 256>, 4> tables_{};
};

/// The third and fourth coordinates.
inline constexpr SobolCoordinate kSobol3(2, 1, {1, 3, 0});
inline constexpr SobolCoordinate kSobol4(3, 1, {1, 3, 1});

}  // namespace raytracing
