#pragma once
// Reads text made of records, one a line: OBJ and MTL. A backslash before a line end continues the
// record on the next line; '#' starts a comment; LF, CR and CRLF end a line.

#include <bit>
#include <cfloat>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "raytracing/io/errors.h"

namespace raytracing {

enum class NumberStatus { ok, malformed, too_large };

struct ParsedNumber {
  const char* end;  ///< behind the last byte that belongs to the number
  float value;
  NumberStatus status;
};

inline bool is_digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }

/// Takes digits from the front of [at, end) and appends them to `value`, which wraps around if they
/// are too many for it. Returns their number.
inline long take_digits(const char*& at, const char* end, std::uint64_t& value) {
  static constexpr std::uint64_t kPowers[] = {1,      10,      100,      1000,     10000,
                                              100000, 1000000, 10000000, 100000000};
  const char* const start = at;
  // Eight bytes at once, as one number (after Lemire 2021, "Number parsing at a gigabyte per
  // second"): the processor need not predict the number of digits.
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

/// Rounds the unsigned number [digits, end), which must have a valid form, without the fast path.
/// `exponent` is the one written after e.
ParsedNumber round_slowly(const char* digits, const char* end, bool negative, long exponent);

/// Reads [+-]digits[.digits][(e|E)[+-]digits] from the front of [at, end), with at least one digit
/// before or after the point; correctly rounded, and faster than std::from_chars for the short
/// numbers that fill model files. Too small values become denormal or 0. The caller checks what
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
    for (; at != end && is_digit(*at); ++at)
      if (exponent < 100'000'000'000) exponent = 10 * exponent + (*at - '0');
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

class TextCursor {
 public:
  /// Skips a UTF-8 byte order mark, which has no columns. Throws InputError for UTF-16. Both
  /// arguments must outlive the cursor.
  TextCursor(std::string_view text, const std::string& file);

  const std::string& file() const { return *file_; }
  bool at_end() const { return at_ == end_; }
  TextPlace place() const { return {line_, static_cast<long>(at_ - line_start_) + 1}; }
  TextLocation location(const TextPlace& where) const { return {*file_, where.line, where.column}; }

  /// Moves over blanks and continued line ends.
  void skip_blanks() {
    while (at_ != end_) {
      if (is_blank(*at_)) {
        ++at_;
      } else if (at_continuation()) {
        ++at_;
        skip_line_end();
      } else {
        return;
      }
    }
  }

  /// True at a line end, a comment or the end of the text.
  bool at_record_end() const { return at_ == end_ || is_line_end(*at_) || *at_ == '#'; }
  /// True where a number may end.
  bool at_separator() const { return at_record_end() || is_blank(*at_) || at_continuation(); }

  /// Takes this byte if it comes next.
  bool accept(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  /// Takes this byte and the blank behind it if they come next.
  bool accept_keyword(char c) {
    if (end_ - at_ < 2 || at_[0] != c || !is_blank(at_[1])) return false;
    at_ += 2;
    return true;
  }
  /// The same for two bytes and a blank.
  bool accept_keyword(char first, char second) {
    if (end_ - at_ < 3 || at_[0] != first || at_[1] != second || !is_blank(at_[2])) return false;
    at_ += 3;
    return true;
  }

  /// Takes the bytes up to the next blank or line end; may be empty.
  std::string_view token() {
    const char* const start = at_;
    while (at_ != end_ && !is_blank(*at_) && !is_line_end(*at_) && !at_continuation()) ++at_;
    return {start, static_cast<std::size_t>(at_ - start)};
  }

  /// Takes [+-]digits if they come next. A value beyond 10^12 may be read as another one beyond it.
  bool integer(std::int64_t& value) {
    const char* p = at_;
    const bool negative = p != end_ && *p == '-';
    if (p != end_ && (*p == '-' || *p == '+')) ++p;
    std::uint64_t magnitude = 0;
    const char* const digits = p;
    const long count = take_digits(p, end_, magnitude);
    if (count == 0) return false;
    if (count > kExactDigits) magnitude = magnitude_of_many(digits, p);
    value = negative ? -static_cast<std::int64_t>(magnitude) : static_cast<std::int64_t>(magnitude);
    at_ = p;
    return true;
  }

  /// Skips blanks and takes a finite number. `what` names it in the InputError when there is none.
  float number(const char* what) {
    skip_blanks();
    const char* const start = at_;
    const ParsedNumber parsed = parse_float(at_, end_);
    at_ = parsed.end;
    if (parsed.status != NumberStatus::ok || !at_separator()) bad_number(start, what);
    return parsed.value;
  }

  /// Takes the rest of the record as one name, trimmed. Since names like "Material #25" are common,
  /// '#' starts a comment here only between blanks.
  std::string name();

  /// Skips blanks and ends the record. Throws InputError when something is left that is no comment.
  void finish_record() {
    skip_blanks();
    if (!at_record_end()) unexpected_text();
    skip_comment();
    skip_line_end();
  }
  /// Skips the rest of the record.
  void skip_record();

  /// Throws InputError.
  [[noreturn]] void fail(const TextPlace& where, const std::string& message) const;

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  bool at_continuation() const { return *at_ == '\\' && (at_ + 1 == end_ || is_line_end(at_[1])); }
  void skip_comment() {
    while (at_ != end_ && !is_line_end(*at_)) ++at_;
  }
  void skip_line_end() {
    if (at_ == end_) return;
    const bool carriage_return = *at_++ == '\r';
    if (carriage_return && at_ != end_ && *at_ == '\n') ++at_;
    ++line_;
    line_start_ = at_;
  }
  static constexpr long kExactDigits = 18;  // a signed 64-bit number holds as many
  // The number that the digits state, or some number of 10^12 or more in place of a larger one.
  static std::uint64_t magnitude_of_many(const char* digits, const char* end);
  [[noreturn]] void bad_number(const char* start, const char* what);
  [[noreturn]] void unexpected_text();

  const char* at_;
  const char* end_;
  const char* line_start_;
  long line_ = 1;
  const std::string* file_;
};

}  // namespace raytracing
