#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace raytracing {

/// Thrown to print a text, such as the help, instead of running the subcommand.
struct TextRequest {
  std::string text;
};

/// The options of one subcommand. Each function below defines an option together with its help
/// text, so that the help and the parser cannot disagree. An OptionList keeps references to the
/// fields that it fills; they must outlive it.
class OptionList {
 public:
  using Parser = std::function<void(const std::string&)>;

  /// `usage` is the beginning of the command line, for example "Raytracing compare".
  OptionList(const std::string& description, const std::string& usage);
  ~OptionList();

  /// Starts a group: the options that follow are listed below this title in the help.
  void group(const std::string& title) { group_ = title; }
  /// Appends text below the options in the help.
  void footer(const std::string& text) { footer_ += text; }
  /// Sets how the message about a surplus positional argument is made from the argument.
  void refuse_extra_with(std::function<std::string(const std::string&)> message) {
    extra_ = std::move(message);
  }

  /// A name without dashes is a positional argument; "--scene,scene" is both an option and a
  /// positional argument.
  void text(const std::string& name, std::string& field, const char* type,
            const std::string& description);
  /// An option that may be repeated, each time with one value.
  void texts(const std::string& name, std::vector<std::string>& field, const char* type,
             const std::string& description);
  /// An option without a value.
  void flag(const std::string& name, bool& field, const std::string& description);
  /// `parser` receives the value and throws UsageError if it is invalid.
  void parsed(const std::string& name, const char* type, const Parser& parser,
              const std::string& description);

  /// An integer in [low, high]. The help states the default unless the field is optional.
  template <class Field>
  void number(const std::string& name, Field& field, std::uint64_t low, std::uint64_t high,
              const std::string& description);
  /// A decimal number in [low, high]. The help states the default unless the field is optional.
  template <class Field>
  void real(const std::string& name, Field& field, double low, double high,
            const std::string& description);
  /// One of the named values.
  template <class Field, class Value>
  void choice(const std::string& name, Field& field,
              const std::vector<std::pair<std::string, Value>>& values,
              const std::string& description);
  /// A comma-separated list of distinct items; `parse` converts one item or throws UsageError.
  template <class Item, class Parse>
  void list(const std::string& name, std::vector<Item>& field, const char* type, Parse parse,
            const std::string& description);

  /// Fills the fields from a command line without program and subcommand names. Throws TextRequest
  /// if it asks for the help, and UsageError, which suggests the nearest option for an unknown one.
  void parse(const std::vector<std::string>& arguments);

 private:
  template <class Field>
  struct ValueOf : std::type_identity<Field> {};
  template <class Value>
  struct ValueOf<std::optional<Value>> : std::type_identity<Value> {};

  void describe(CLI::Option* option, const char* type, const std::string& description) const;
  std::vector<std::string> names() const;
  [[noreturn]] void throw_unexpected(const std::string& argument) const;

  std::unique_ptr<CLI::App> app_;
  std::string group_ = "Options";
  std::string footer_;
  std::function<std::string(const std::string&)> extra_;
};

/// Throws a UsageError that refers to --help.
[[noreturn]] void throw_usage(const std::string& what);

/// An integer in decimal digits in [low, high]. Throws UsageError, which names `option`.
std::uint64_t whole_number(std::string_view option, std::string_view text, std::uint64_t low,
                           std::uint64_t high);

/// A finite decimal number in [low, high]. Throws UsageError, which names `option`.
double real_number(std::string_view option, std::string_view text, double low, double high);

/// The index of `text` in `names`. Throws UsageError, which suggests the nearest name, if it is not
/// among them.
std::size_t index_of_name(std::string_view option, const std::string& text,
                          const std::vector<std::string>& names);

/// The items of a comma-separated list.
std::vector<std::string> split_list(const std::string& text);

/// The text with line breaks between words so that no line is longer than `width` bytes; further
/// lines are indented by `indent` spaces.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent = 0);

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& names);

/// " Default: 4." for a field that holds 4, and "" for an optional field.
template <class Field>
std::string default_text(const Field& field) {
  if constexpr (std::is_arithmetic_v<Field>) return fmt::format(" Default: {}.", field);
  return "";
}

template <class Field>
void OptionList::number(const std::string& name, Field& field, std::uint64_t low,
                        std::uint64_t high, const std::string& description) {
  const auto parser = [&field, name, low, high](const std::string& text) {
    field = static_cast<typename ValueOf<Field>::type>(whole_number(name, text, low, high));
  };
  parsed(name, "N", parser, description + default_text(field));
}

template <class Field>
void OptionList::real(const std::string& name, Field& field, double low, double high,
                      const std::string& description) {
  const auto parser = [&field, name, low, high](const std::string& text) {
    field = real_number(name, text, low, high);
  };
  parsed(name, "X", parser, description + default_text(field));
}

template <class Field, class Value>
void OptionList::choice(const std::string& name, Field& field,
                        const std::vector<std::pair<std::string, Value>>& values,
                        const std::string& description) {
  std::vector<std::string> names;
  names.reserve(values.size());
  for (const auto& value : values) names.push_back(value.first);
  const auto parser = [&field, name, names, values](const std::string& text) {
    field = values[index_of_name(name, text, names)].second;
  };
  parsed(name, "NAME", parser, description);
}

template <class Item, class Parse>
void OptionList::list(const std::string& name, std::vector<Item>& field, const char* type,
                      Parse parse, const std::string& description) {
  const auto parser = [&field, name, parse](const std::string& text) {
    field.clear();
    for (const std::string& part : split_list(text)) {
      const Item item = parse(part);
      if (std::find(field.begin(), field.end(), item) != field.end())
        throw_usage(fmt::format("{}: {} is listed twice", name, part));
      field.push_back(item);
    }
  };
  parsed(name, type, parser, description);
}

}  // namespace raytracing
