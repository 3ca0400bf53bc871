#include "html_template.h"

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace raytracing {
namespace {

using Json = nlohmann::json;

void append_escaped(std::string_view text, std::string& out) {
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
}

// Writes a template with its tags replaced by values.
class TemplateWriter {
 public:
  explicit TemplateWriter(const Json& data) : context_{&data} {}

  void fill(std::string_view text) {
    while (true) {
      const std::size_t open = text.find("{{");
      out_ += text.substr(0, open);
      if (open == std::string_view::npos) return;
      text.remove_prefix(open + 2);
      const std::string tag(cut(text, "}}"));
      if (tag.starts_with('!')) continue;
      if (tag.starts_with('#')) {
        fill_section(cut(text, "{{/" + tag.substr(1) + "}}"), lookup(tag.substr(1)));
      } else {
        append_escaped(lookup(tag).get_ref<const std::string&>(), out_);
      }
    }
  }

  std::string take() { return std::move(out_); }

 private:
  // Returns the part before `end` and removes both from the text.
  static std::string_view cut(std::string_view& text, const std::string& end) {
    const std::size_t length = text.find(end);
    if (length == std::string_view::npos) throw std::logic_error("template lacks " + end);
    const std::string_view part = text.substr(0, length);
    text.remove_prefix(length + end.size());
    return part;
  }

  const Json& lookup(const std::string& name) const {
    if (name == ".") return *context_.back();
    for (auto level = context_.rbegin(); level != context_.rend(); ++level) {
      const auto found = (*level)->find(name);
      if (found != (*level)->end()) return *found;
    }
    throw std::logic_error("template asks for " + name);
  }

  void fill_section(std::string_view body, const Json& value) {
    if (value.is_array()) {
      for (const Json& element : value) fill_with(body, element);
    } else if (!value.is_null() && value != "") {
      fill_with(body, value);
    }
  }

  void fill_with(std::string_view body, const Json& value) {
    context_.push_back(&value);
    fill(body);
    context_.pop_back();
  }

  std::vector<const Json*> context_;  // innermost last
  std::string out_;
};

}  // namespace

std::string escape_html(std::string_view text) {
  std::string out;
  append_escaped(text, out);
  return out;
}

std::string fill_template(std::string_view text, const Json& data) {
  TemplateWriter writer(data);
  writer.fill(text);
  return writer.take();
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  while (!bytes.empty()) {
    const std::string_view group = bytes.substr(0, 3);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      bits = bits << 8 | (i < group.size() ? static_cast<unsigned char>(group[i]) : 0u);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      out += i <= group.size() ? kDigits[bits >> (18 - 6 * i) & 63] : '=';
    }
    bytes.remove_prefix(group.size());
  }
  return out;
}

}  // namespace raytracing
