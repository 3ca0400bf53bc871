#include "options.h"

#include <charconv>
#include <memory>
#include <string_view>
#include <system_error>

#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

// CLI11 prints descriptions from column 30 on.
constexpr std::size_t kHelpWidth = 98, kDescriptionWidth = 68;

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped(option->get_description(), kDescriptionWidth);
  }
  std::string make_footer(const CLI::App* app) const override {
    return "\nExit codes: 0 success, 1 failed check or unexpected error, 2 invalid command line,\n"
           "3 invalid input, 4 output not written, 128 + N stopped by signal N.\n" +
           app->get_footer();
  }
};

// Groups and the footer follow up to two blank lines, which depends on the version of CLI11.
std::string with_single_blank_lines(std::string text) {
  for (std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;) text.erase(at, 1);
  return text.erase(text.find_last_not_of('\n') + 1) + "\n";
}

// The messages of CLI11 use terms of its own, so only the name of the option is taken from them.
[[noreturn]] void throw_mismatch(const std::string& what) {
  std::string name = what.substr(0, what.find_first_of(": "));
  if (!name.starts_with("-")) name = "--" + name;
  if (what.ends_with("missing")) throw_usage(name + ": needs a value");
  if (what.find("At Most") != std::string::npos) throw_usage(name + ": given more than once");
  throw_usage(name + ": takes no value");
}

std::string out_of_range(std::string_view text, auto low, auto high) {
  return fmt::format("{} is not between {} and {}", text, low, high);
}

}  // namespace

OptionList::OptionList(const std::string& description, const std::string& usage)
    : app_(wrapped(description, kHelpWidth), usage),
      extra_([](const std::string& argument) { return argument + ": one argument too many"; }) {
  app_.set_help_flag("-h,--help", "Print this help and exit.");
  app_.formatter(std::make_shared<HelpFormatter>());
}

void OptionList::parse(const std::vector<std::string>& arguments) {
  try {
    app_.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ExtrasError&) {
    throw_unexpected(app_.remaining().front());
  } catch (const CLI::ArgumentMismatch& error) {
    throw_mismatch(error.what());
  } catch (const CLI::ValidationError& error) {
    throw UsageError(error.what());
  } catch (const CLI::CallForHelp&) {
    throw TextRequest{with_single_blank_lines(app_.help())};
  } catch (const CLI::ParseError& error) {
    throw_usage(error.what());
  }
}

void OptionList::throw_unexpected(const std::string& argument) const {
  if (!argument.starts_with("-")) throw_usage(extra_(argument));
  std::vector<std::string> known;
  for (const CLI::Option* option : app_.get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  const std::string name = argument.substr(0, argument.find('='));
  throw_usage(name + ": unknown option; the nearest is " + nearest_name(name, known));
}

void throw_usage(const std::string& what) {
  throw UsageError(what + " (--help lists all options)");
}

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  const auto read = [low, high](std::string& text) -> std::string {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool negative = text.size() > 1 && text[0] == '-' &&
                          text.find_first_not_of("0123456789", 1) == std::string::npos;
    if (!negative && (stop != end || error == std::errc::invalid_argument))
      return fmt::format("'{}' is not an integer", text);
    if (negative || error != std::errc() || value < low || value > high)
      return out_of_range(text, low, high);
    text = std::to_string(value);
    return "";
  };
  return {read, ""};
}

CLI::Validator real_number(double low, double high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument ||
        text.find_first_not_of("0123456789+-.eE") != std::string::npos)
      return fmt::format("'{}' is not a number", text);
    if (error != std::errc() || value < low || value > high) return out_of_range(text, low, high);
    return "";
  };
  return {check, ""};
}

CLI::Validator one_of(const std::vector<std::string>& names) {
  const auto check = [names](const std::string& text) -> std::string {
    if (std::find(names.begin(), names.end(), text) != names.end()) return "";
    return fmt::format("must be {}, not '{}'; the nearest is {}", alternatives(names), text,
                       nearest_name(text, names));
  };
  return {check, ""};
}

std::string checked(const std::string& option, std::string text, const CLI::Validator& validator) {
  const std::string fault = validator(text);
  if (!fault.empty()) throw CLI::ValidationError(option, fault);
  return text;
}

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream items(text + ',');
  for (std::string part; std::getline(items, part, ',');) parts.push_back(part);
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
