#pragma once
// Walks over text made of records, one a line: OBJ and MTL. A backslash before a line end continues
// the record on the next line, '#' starts a comment. LF, CR and CRLF end a line.

#include <cstdint>
#include <string>
#include <string_view>

#include "number.h"
#include "raytracing/io/errors.h"

namespace raytracing {

/// Where in a text: physical line and byte column, both from 1. A byte order mark has no columns.
struct TextPlace {
  long line = 0;
  long column = 0;
};

/// The bytes in quotes for a message: printable ASCII as it is, the rest as \xNN, long ones cut.
std::string quoted(std::string_view bytes);

class TextCursor {
 public:
  /// Skips a UTF-8 byte order mark. Throws InputError for UTF-16. Both arguments must outlive it.
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

  /// Takes [+-]digits if they come next. Values beyond 10^12 are only known to be as large.
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
  /// Leaves the rest of the record out.
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
  static constexpr long kExactDigits = 18;  // that 64 bits hold, with a sign
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
