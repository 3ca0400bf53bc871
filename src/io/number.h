#pragma once
// Decimal numbers in text, correctly rounded to float and faster than std::from_chars for the short
// ones that model files are full of.

#include <bit>
#include <cfloat>
#include <cstdint>
#include <cstring>

namespace raytracing {

enum class NumberStatus { ok, malformed, too_large };

struct ParsedNumber {
  const char* end;  ///< behind the last byte that belongs to the number
  float value;
  NumberStatus status;
};

inline bool is_digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }

/// Takes digits from the front of [at, end) and appends them to `value`, which wraps around when
/// they are too many for it. Returns how many.
inline long take_digits(const char*& at, const char* end, std::uint64_t& value) {
  static constexpr std::uint64_t kPowers[] = {1,      10,      100,      1000,     10000,
                                              100000, 1000000, 10000000, 100000000};
  const char* const start = at;
  // Eight bytes at once, as one number (after Lemire 2021, "Number parsing at a gigabyte per
  // second"): one test where a loop would guess how many digits come.
  while (std::endian::native == std::endian::little && end - at >= 8) {
    std::uint64_t word;
    std::memcpy(&word, at, 8);
    // A digit is 0x30 .. 0x39. A carry out of a byte reaches only bytes behind a byte that is none.
    const std::uint64_t none =
        ((word & 0xf0f0f0f0f0f0f0f0u) ^ 0x3030303030303030u) |
        (((word + 0x0606060606060606u) & 0xf0f0f0f0f0f0f0f0u) ^ 0x3030303030303030u);
    const int count = std::countr_zero(none) / 8;           // 8 when all are digits
    const int half = 4 * (8 - count);                       // shifting by 64 at once is not defined
    word = ((word & 0x0f0f0f0f0f0f0f0fu) << half) << half;  // zeros in front
    word = (word * (1 + (10 << 8)) >> 8) & 0x00ff00ff00ff00ffu;
    word = (word * (1 + (100 << 16)) >> 16) & 0x0000ffff0000ffffu;
    word = word * (1 + (10000ull << 32)) >> 32;
    value = value * kPowers[count] + word;
    at += count;
    if (count < 8) return at - start;
  }
  for (; at != end && is_digit(*at); ++at) value = 10 * value + std::uint64_t(*at - '0');
  return at - start;
}

/// Rounds the unsigned number [digits, end) of valid form. `exponent` is the one written after e.
ParsedNumber round_slowly(const char* digits, const char* end, bool negative, long exponent);

/// Reads [+-]digits[.digits][(e|E)[+-]digits] from the front of [at, end), with at least one digit
/// before or after the point. Too small values become denormal or 0. The caller checks what
/// follows.
inline ParsedNumber parse_float(const char* at, const char* end) {
  static constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                       1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                       1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  bool negative = false;
  if (at != end && (*at == '-' || *at == '+')) negative = *at++ == '-';
  const char* const start = at;
  std::uint64_t mantissa = 0;  // wraps around beyond 19 digits; then it is not used
  long digits = take_digits(at, end, mantissa);
  long scale = 0;
  if (at != end && *at == '.') {
    ++at;
    scale = -take_digits(at, end, mantissa);
    digits -= scale;
  }
  if (digits == 0) return {at, 0, NumberStatus::malformed};
  long exponent = 0;
  if (at != end && (*at == 'e' || *at == 'E')) {
    ++at;
    bool below = false;
    if (at != end && (*at == '-' || *at == '+')) below = *at++ == '-';
    if (at == end || !is_digit(*at)) return {at, 0, NumberStatus::malformed};
    for (; at != end && is_digit(*at); ++at) {
      if (exponent < 100'000'000'000) exponent = 10 * exponent + (*at - '0');
    }
    if (below) exponent = -exponent;
  }
  scale += exponent;
  // Clinger 1990: both factors are exact doubles here, so that one operation rounds correctly.
  // Rounding again to float is right too unless the double lies midway between two floats.
  if (digits <= 19 && mantissa < (std::uint64_t{1} << 53) && scale >= -22 && scale <= 22) {
    const double whole = static_cast<double>(mantissa);
    const double value = scale < 0 ? whole / kPowers[-scale] : whole * kPowers[scale];
    const bool midway = (std::bit_cast<std::uint64_t>(value) & 0x1fffffffu) == 0x10000000u;
    if (value == 0 || (!midway && value >= double{FLT_MIN} && value < double{FLT_MAX})) {
      const float rounded = static_cast<float>(value);
      return {at, negative ? -rounded : rounded, NumberStatus::ok};
    }
  }
  return round_slowly(start, at, negative, exponent);
}

}  // namespace raytracing
