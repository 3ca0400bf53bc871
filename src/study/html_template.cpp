#include "html_template.h"

#include <stdexcept>
#include <vector>

namespace raytracing {
namespace {

using Json = nlohmann::json;

std::string_view html_entity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

void append_escaped(std::string_view text, std::string& out) {
  for (const char c : text) {
    const std::string_view entity = html_entity(c);
    if (entity.empty()) {
      out += c;
    } else {
      out += entity;
    }
  }
}

class Filler {
 public:
  explicit Filler(const Json& data) : context_{&data} {}

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
  /// What stands before `end`; the text goes on behind it.
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
  Filler filler(data);
  filler.fill(text);
  return filler.take();
}

}  // namespace raytracing
