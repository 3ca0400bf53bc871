#pragma once
// Options of subcommands by CLI11, with the help and the messages of this program.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace raytracing {

/// Thrown to print a text, such as the help, instead of running the subcommand.
struct TextRequest {
  std::string text;
};

/// Throws a UsageError that refers to --help.
[[noreturn]] void throw_usage(const std::string& what);

/// Accepts an integer in decimal digits in [low, high]. CLI11 by itself reads 010 as 8 and -1 as
/// 2^64 - 1, and clamps what is too large.
CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);
/// Accepts a finite decimal number in [low, high].
CLI::Validator real_number(double low, double high);
/// Accepts one of the names; the message suggests the nearest.
CLI::Validator one_of(const std::vector<std::string>& names);

/// Returns the text as the validator leaves it. Throws CLI::ValidationError, which names `option`.
std::string checked(const std::string& option, std::string text, const CLI::Validator& validator);

/// Splits a list at its commas.
std::vector<std::string> split_list(const std::string& text);

/// Breaks the text into lines of at most `width` bytes where there are spaces; further lines are
/// indented by `indent` spaces.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent = 0);

/// Returns "a, b or c".
std::string alternatives(const std::vector<std::string>& names);

/// Returns " Default: 4." for a field that holds 4, and "" for an optional field.
template <class Field>
std::string default_text(const Field& field) {
  if constexpr (std::is_arithmetic_v<Field>) return fmt::format(" Default: {}.", field);
  return "";
}

/// The options of one subcommand. Each function below defines an option together with its help
/// text, so that the help and the parser cannot disagree. The fields that the options fill must
/// outlive the list.
class OptionList {
 public:
  /// `usage` is the beginning of the command line, for example "Raytracing compare".
  OptionList(const std::string& description, const std::string& usage);

  /// Starts a group: the options that follow are listed below this title in the help.
  void group(const std::string& title) { app_.option_defaults()->group(title); }
  /// Sets the text below the options in the help.
  void footer(const std::string& text) { app_.footer(text); }
  /// Sets how the message about a surplus positional argument is made from the argument.
  void refuse_extra_with(std::function<std::string(const std::string&)> message) {
    extra_ = std::move(message);
  }

  /// Adds an option with a value. A name without dashes is a positional argument; "--scene,scene"
  /// is both an option and a positional argument.
  template <class Field>
  CLI::Option* value(const std::string& name, Field& field, const std::string& type,
                     const std::string& description) {
    return app_.add_option(name, field, description)->type_name(type);
  }
  /// Adds an option that may be repeated, each time with one value.
  CLI::Option* values(const std::string& name, std::vector<std::string>& field,
                      const std::string& type, const std::string& description) {
    return value(name, field, type, description)->take_all()->expected(1);
  }
  /// Adds an option without a value.
  void flag(const std::string& name, bool& field, const std::string& description) {
    app_.add_flag(name, field, description)->disable_flag_override();
  }
  /// Adds an integer in [low, high]. The help states the default unless the field is optional.
  template <class Field>
  CLI::Option* number(const std::string& name, Field& field, std::uint64_t low, std::uint64_t high,
                      const std::string& description) {
    return value(name, field, "N", description + default_text(field))
        ->transform(whole_number(low, high));
  }
  /// Adds a decimal number in [low, high]. The help states the default unless the field is
  /// optional.
  template <class Field>
  CLI::Option* real(const std::string& name, Field& field, double low, double high,
                    const std::string& description) {
    return value(name, field, "X", description + default_text(field))
        ->check(real_number(low, high));
  }
  /// Adds an option whose value is one of these names.
  template <class Value>
  void choice(const std::string& name, Value& field,
              const std::vector<std::pair<std::string, Value>>& values,
              const std::string& description);
  /// Adds an option whose value `parse` converts. It throws CLI::ValidationError.
  void parsed(const std::string& name, const std::string& type,
              const std::function<void(const std::string&)>& parse,
              const std::string& description) {
    app_.add_option_function(name, parse, description)->type_name(type);
  }
  /// Adds an option whose value is a list of different items with commas between them. `parse`
  /// converts an item or throws CLI::ValidationError.
  template <class Item, class Parse>
  void list(const std::string& name, std::vector<Item>& field, const std::string& type, Parse parse,
            const std::string& description);

  /// Fills the fields from a command line without program and subcommand names. Throws TextRequest
  /// if it asks for the help, and UsageError, which suggests the nearest option for an unknown one.
  void parse(const std::vector<std::string>& arguments);

 private:
  [[noreturn]] void throw_unexpected(const std::string& argument) const;

  CLI::App app_;
  std::function<std::string(const std::string&)> extra_;
};

template <class Value>
void OptionList::choice(const std::string& name, Value& field,
                        const std::vector<std::pair<std::string, Value>>& values,
                        const std::string& description) {
  std::vector<std::string> names;
  for (const auto& named : values) names.push_back(named.first);
  const auto read = [&field, name, values, names](const std::string& text) {
    checked(name, text, one_of(names));
    for (const auto& [known, meaning] : values)
      if (known == text) field = meaning;
  };
  parsed(name, "NAME", read, description);
}

template <class Item, class Parse>
void OptionList::list(const std::string& name, std::vector<Item>& field, const std::string& type,
                      Parse parse, const std::string& description) {
  const auto parse_all = [&field, name, parse](const std::string& text) {
    field.clear();
    for (const std::string& part : split_list(text)) {
      const Item item = parse(part);
      if (std::find(field.begin(), field.end(), item) != field.end())
        throw_usage(fmt::format("{}: {} is listed twice", name, part));
      field.push_back(item);
    }
  };
  parsed(name, type, parse_all, description);
}

}  // namespace raytracing
