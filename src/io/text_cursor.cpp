#include "text_cursor.h"

#include <cstdlib>

namespace raytracing {

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

void TextCursor::fail(const TextPlace& where, const std::string& message) const {
  throw InputError(location(where), message);
}

float TextCursor::extreme_number(const char* stop, const char* what) {
  const char* const start = at_;
  const std::string digits(after_plus(), stop);
  // Without a digit there is no number, but nothing, "inf" or "nan".
  if (digits.find_first_of("0123456789") == std::string::npos) bad_number(start, what);
  // std::from_chars does not tell numbers that are too small from those that are too large.
  const float value = std::strtof(digits.c_str(), nullptr);
  if (std::isinf(value)) bad_number(start, what, true);
  at_ = stop;
  if (!at_separator()) bad_number(start, what);
  return value;
}

void TextCursor::bad_number(const char* start, const char* what, bool too_large) {
  at_ = start;
  const TextPlace where = place();
  const std::string expected = std::string("expected ") + what;
  if (at_record_end()) fail(where, "truncated record: " + expected);
  const std::string_view found = token();
  if (found.find(',') != std::string_view::npos)
    fail(where, expected + ", found " + quoted(found) + "; use a point as the decimal mark");
  fail(where, expected + ", found " + quoted(found) + (too_large ? ", too large for a float" : ""));
}

void TextCursor::unexpected_text() {
  const TextPlace where = place();
  fail(where, "unexpected " + quoted(token()) + " at the end of the record");
}

}  // namespace raytracing
