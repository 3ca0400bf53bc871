#pragma once
// Reads text made of records, one a line: OBJ and MTL. A backslash before a line end continues the
// record on the next line; '#' starts a comment; LF, CR and CRLF end a line.

#include <cfloat>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include "raytracing/io/errors.h"

namespace raytracing {

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

  /// Takes the bytes up to the next blank or line end; may be empty.
  std::string_view token() {
    const char* const start = at_;
    while (at_ != end_ && !is_blank(*at_) && !is_line_end(*at_) && !at_continuation()) ++at_;
    return {start, static_cast<std::size_t>(at_ - start)};
  }

  /// Takes [+-]digits if they come next. A number beyond 64 bits is read as one of 13 nines.
  bool integer(std::int64_t& value) {
    const auto [stop, error] = std::from_chars(after_plus(), end_, value);
    if (error == std::errc::invalid_argument) return false;
    if (error != std::errc()) value = (*at_ == '-' ? -1 : 1) * std::int64_t{9'999'999'999'999};
    at_ = stop;
    return true;
  }

  /// Skips blanks and takes a finite number: [+-]digits[.digits][(e|E)[+-]digits], with a digit
  /// before or after the point. It is rounded correctly; too small ones become denormal or 0.
  /// `what` names it in the InputError when there is none.
  float number(const char* what) {
    skip_blanks();
    float value = 0;
    const char* const start = at_;
    const auto [stop, error] = std::from_chars(after_plus(), end_, value);
    if (error != std::errc() || !(std::abs(value) <= FLT_MAX)) return extreme_number(stop, what);
    at_ = stop;
    if (!at_separator()) bad_number(start, what);
    return value;
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
  // The place of what comes next, behind a plus sign, which std::from_chars does not read.
  const char* after_plus() const {
    return end_ - at_ > 1 && at_[0] == '+' && at_[1] != '-' ? at_ + 1 : at_;
  }
  // Takes the number that ends at `stop` if it is too small for a float.
  float extreme_number(const char* stop, const char* what);
  [[noreturn]] void bad_number(const char* start, const char* what, bool too_large = false);
  [[noreturn]] void unexpected_text();

  const char* at_;
  const char* end_;
  const char* line_start_;
  long line_ = 1;
  const std::string* file_;
};

}  // namespace raytracing
