#include "options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <sstream>
#include <system_error>

#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

// CLI11 prints descriptions from column 30 on.
constexpr std::size_t kHelpWidth = 98, kDescriptionWidth = 68;

constexpr const char* kExitCodes =
    "Exit codes: 0 success, 1 failed check or unexpected error, 2 invalid command line,\n"
    "3 invalid input, 4 output not written, 128 + N stopped by signal N.\n";

// Groups, and the end of the help, are followed by up to two blank lines, which depends on the
// version of CLI11.
std::string with_single_blank_lines(std::string text) {
  for (std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;) text.erase(at, 1);
  return text.erase(text.find_last_not_of('\n') + 1) + "\n\n";
}

// The messages of CLI11 use terms of its own, so only the name of the option is taken from them.
[[noreturn]] void throw_mismatch(const std::string& what) {
  std::string name = what.substr(0, what.find_first_of(": "));
  if (!name.starts_with("-")) name = "--" + name;
  if (what.ends_with("missing")) throw_usage(name + ": needs a value");
  if (what.find("At Most") != std::string::npos) throw_usage(name + ": given more than once");
  throw_usage(name + ": takes no value");
}

[[noreturn]] void throw_out_of_range(std::string_view option, std::string_view text, auto low,
                                     auto high) {
  throw UsageError(fmt::format("{}: {} is not between {} and {}", option, text, low, high));
}

}  // namespace

OptionList::OptionList(const std::string& description, const std::string& usage)
    : app_(std::make_unique<CLI::App>(wrapped(description, kHelpWidth), usage)),
      extra_([](const std::string& argument) { return argument + ": one argument too many"; }) {
  app_->set_help_flag("-h,--help", "Print this help and exit.");
}

OptionList::~OptionList() = default;

void OptionList::describe(CLI::Option* option, const char* type,
                          const std::string& description) const {
  option->type_name(type)->group(group_)->description(wrapped(description, kDescriptionWidth));
}

void OptionList::text(const std::string& name, std::string& field, const char* type,
                      const std::string& description) {
  describe(app_->add_option(name, field), type, description);
}

void OptionList::texts(const std::string& name, std::vector<std::string>& field, const char* type,
                       const std::string& description) {
  describe(app_->add_option(name, field)->take_all()->expected(1), type, description);
}

void OptionList::flag(const std::string& name, bool& field, const std::string& description) {
  describe(app_->add_flag(name, field)->disable_flag_override(), "", description);
}

// Numbers come here too: CLI11 reads 010 as 8, -1 as 2^64 - 1, and clamps what is too large.
void OptionList::parsed(const std::string& name, const char* type, const Parser& parser,
                        const std::string& description) {
  describe(app_->add_option_function<std::string>(name, parser), type, description);
}

void OptionList::parse(const std::vector<std::string>& arguments) {
  try {
    app_->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ExtrasError&) {
    throw_unexpected(app_->remaining().front());
  } catch (const CLI::ArgumentMismatch& error) {
    throw_mismatch(error.what());
  } catch (const CLI::CallForHelp&) {
    throw TextRequest{with_single_blank_lines(app_->help()) + kExitCodes + footer_};
  } catch (const CLI::ParseError& error) {
    throw_usage(error.what());
  }
}

std::vector<std::string> OptionList::names() const {
  std::vector<std::string> result;
  for (const CLI::Option* option : app_->get_options())
    for (const std::string& name : option->get_lnames()) result.push_back("--" + name);
  return result;
}

void OptionList::throw_unexpected(const std::string& argument) const {
  if (!argument.starts_with("-")) throw_usage(extra_(argument));
  const std::string name = argument.substr(0, argument.find('='));
  throw_usage(name + ": unknown option; the nearest is " + nearest_name(name, names()));
}

void throw_usage(const std::string& what) {
  throw UsageError(what + " (--help lists all options)");
}

std::uint64_t whole_number(std::string_view option, std::string_view text, std::uint64_t low,
                           std::uint64_t high) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool negative = text.size() > 1 && text[0] == '-' &&
                        text.find_first_not_of("0123456789", 1) == std::string_view::npos;
  if (!negative && (stop != end || error == std::errc::invalid_argument))
    throw UsageError(fmt::format("{}: '{}' is not an integer", option, text));
  if (negative || error != std::errc() || value < low || value > high)
    throw_out_of_range(option, text, low, high);
  return value;
}

double real_number(std::string_view option, std::string_view text, double low, double high) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument ||
      text.find_first_not_of("0123456789+-.eE") != std::string_view::npos)
    throw UsageError(fmt::format("{}: '{}' is not a number", option, text));
  if (error != std::errc() || value < low || value > high)
    throw_out_of_range(option, text, low, high);
  return value;
}

std::size_t index_of_name(std::string_view option, const std::string& text,
                          const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end())
    throw UsageError(fmt::format("{}: must be {}, not '{}'; the nearest is {}", option,
                                 alternatives(names), text, nearest_name(text, names)));
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::string result;
  std::size_t line = 0;  // where the text of the current line begins
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (result.size() > line && result.size() + 1 + word.size() - line > width) {
      result += '\n' + std::string(indent, ' ');
      line = result.size();
    } else if (!result.empty()) {
      result += ' ';
    }
    result += word;
  }
  return result;
}

std::string alternatives(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace raytracing
