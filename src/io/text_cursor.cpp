#include "text_cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace raytracing {

ParsedNumber round_slowly(const char* digits, const char* end, bool negative, long exponent) {
  float value = 0;
  const auto [stop, error] = std::from_chars(digits, end, value);
  if (error == std::errc::result_out_of_range || std::isinf(value)) {
    // from_chars does not distinguish overflow from underflow: find the decimal magnitude.
    const char* const point = std::find_if_not(digits, end, is_digit);
    const char* const first =
        std::find_if(digits, end, [](char c) { return c >= '1' && c <= '9'; });
    const long magnitude = exponent + static_cast<long>(point - first);
    if (magnitude > 0) return {end, 0, NumberStatus::too_large};
    value = 0;
  }
  return {end, negative ? -value : value, NumberStatus::ok};
}

TextCursor::TextCursor(std::string_view text, const std::string& file)
    : at_(text.data()), end_(text.data() + text.size()), line_start_(text.data()), file_(&file) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    fail({1, 1}, "UTF-16 text is not supported");
  if (text.starts_with("\xef\xbb\xbf")) line_start_ = at_ += 3;
}

std::string TextCursor::name() {
  std::string text;
  skip_blanks();
  bool after_blank = true;
  while (at_ != end_ && !is_line_end(*at_)) {
    if (at_continuation()) {
      skip_blanks();
      text += ' ';
      after_blank = true;
      continue;
    }
    const bool before_blank = at_ + 1 == end_ || is_blank(at_[1]) || is_line_end(at_[1]);
    if (*at_ == '#' && after_blank && before_blank) break;
    after_blank = is_blank(*at_);
    text += *at_++;
  }
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  skip_comment();
  return text;
}

void TextCursor::skip_record() {
  while (at_ != end_ && !is_line_end(*at_)) {
    if (*at_ == '#') return finish_record();
    if (at_continuation())
      skip_blanks();
    else
      ++at_;
  }
  skip_line_end();
}

std::uint64_t TextCursor::magnitude_of_many(const char* digits, const char* end) {
  std::uint64_t magnitude = 0;
  for (; digits != end && magnitude < 1'000'000'000'000; ++digits)
    magnitude = 10 * magnitude + static_cast<std::uint64_t>(*digits - '0');
  return magnitude;
}

void TextCursor::fail(const TextPlace& where, const std::string& message) const {
  throw InputError(location(where), message);
}

void TextCursor::bad_number(const char* start, const char* what) {
  const bool too_large = parse_float(start, end_).status == NumberStatus::too_large;
  at_ = start;
  const TextPlace where = place();
  const std::string expected = std::string("expected ") + what;
  if (at_record_end()) fail(where, "truncated record: " + expected);
  const std::string_view found = token();
  if (found.find(',') != std::string_view::npos)
    fail(where, expected + ", found " + quoted(found) + "; use a point as the decimal mark");
  if (too_large) fail(where, expected + ", found " + quoted(found) + ", too large for a float");
  fail(where, expected + ", found " + quoted(found));
}

void TextCursor::unexpected_text() {
  const TextPlace where = place();
  fail(where, "unexpected " + quoted(token()) + " at the end of the record");
}

}  // namespace raytracing
