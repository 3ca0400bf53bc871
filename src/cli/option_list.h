#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "commands.h"
#include "option_values.h"

namespace CLI {
class App;
}

namespace raytracing {

/// The one list of a subcommand's options: parsing and help both come from it. What is added must
/// outlive the list, which keeps references to the fields it fills.
class OptionList {
 public:
  using Set = std::function<void(const std::string&)>;

  /// `usage` is how the command line begins: "Raytracing compare".
  OptionList(const std::string& description, const std::string& usage);
  ~OptionList();

  /// A name without dashes is a positional argument; "--scene,scene" is both.
  void add_text(const std::string& name, std::string& value, const char* type,
                const std::string& description);
  /// An option that may be given several times, with one value each.
  void add_texts(const std::string& name, std::vector<std::string>& values, const char* type,
                 const std::string& description);
  /// `set` gets the option's text and throws UsageError for what it does not like.
  void add_parsed(const std::string& name, const char* type, const Set& set,
                  const std::string& description);
  void add_choice(const std::string& name, const std::vector<std::string>& names, const Set& set,
                  const std::string& description);
  void add_switch(const std::string& name, bool& value, const std::string& description);

  /// A whole number within [low, high] into an integer or an optional one.
  template <class Field>
  void add_number(const std::string& name, Field& value, std::uint64_t low, std::uint64_t high,
                  const std::string& description) {
    const auto set = [&value, name, low, high](const std::string& text) {
      value = static_cast<typename NumberOf<Field>::type>(whole_number(name, text, low, high));
    };
    add_parsed(name, "N", set, description);
  }
  /// A decimal number within [low, high] into a double or an optional one.
  template <class Field>
  void add_real(const std::string& name, Field& value, double low, double high,
                const std::string& description) {
    const auto set = [&value, name, low, high](const std::string& text) {
      value = real_number(name, text, low, high);
    };
    add_parsed(name, "X", set, description);
  }

  /// What an argument too many is told; the default is "one argument too many".
  void refuse_extra_with(std::function<std::string()> why) { why_extra_ = std::move(why); }
  /// Text that stands below the options in the help.
  void add_footer(const std::string& text) { footer_ += text; }

  /// Fills the fields. Returns the help where the command line asks for it; throws UsageError,
  /// which names the nearest option where there is none of that name.
  std::optional<std::string> parse(const Arguments& arguments);

 private:
  // The number behind an optional one.
  template <class Field>
  struct NumberOf : std::type_identity<Field> {};
  template <class Number>
  struct NumberOf<std::optional<Number>> : std::type_identity<Number> {};

  std::string help() const;
  std::vector<std::string> names() const;
  [[noreturn]] void throw_not_expected(const std::string& argument) const;

  std::unique_ptr<CLI::App> app_;
  std::function<std::string()> why_extra_;
  std::string footer_;
};

/// Throws UsageError with a hint at the help.
[[noreturn]] void throw_usage(const std::string& what);

}  // namespace raytracing
