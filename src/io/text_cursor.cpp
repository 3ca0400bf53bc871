#include "text_cursor.h"

namespace raytracing {

std::string quoted(std::string_view bytes) {
  constexpr std::size_t kLongest = 40;
  constexpr char kHex[] = "0123456789abcdef";
  std::string text = "'";
  for (const char c : bytes.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      text += c;
    } else {
      text += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return text + (bytes.size() > kLongest ? "...'" : "'");
}

TextCursor::TextCursor(std::string_view text, const std::string& file)
    : at_(text.data()), end_(text.data() + text.size()), line_start_(text.data()), file_(&file) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    fail({1, 1}, "UTF-16 text is not supported");
  }
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
    if (at_continuation()) {
      skip_blanks();
    } else {
      ++at_;
    }
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
  if (found.find(',') != std::string_view::npos) {
    fail(where, expected + ", found " + quoted(found) + "; decimals are written with a point");
  }
  if (too_large) fail(where, expected + ", found " + quoted(found) + ", too large for a float");
  fail(where, expected + ", found " + quoted(found));
}

void TextCursor::unexpected_text() {
  const TextPlace where = place();
  fail(where, "unexpected " + quoted(token()) + " at the end of the record");
}

}  // namespace raytracing
