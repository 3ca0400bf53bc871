#include "option_list.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "raytracing/io/errors.h"
#include "raytracing/io/nearest_name.h"

namespace raytracing {
namespace {

constexpr std::size_t kHelpWidth = 68;  // of the descriptions: CLI11 starts them at column 30

// CLI11's texts speak of its own terms, so only the option's name is taken from them.
[[noreturn]] void throw_mismatch(const std::string& what) {
  std::string name = what.substr(0, what.find_first_of(": "));
  if (!name.starts_with("-")) name = "--" + name;
  if (what.ends_with("missing")) throw_usage(name + ": needs a value");
  if (what.find("At Most") != std::string::npos) throw_usage(name + ": given more than once");
  throw_usage(name + ": takes no value");
}

}  // namespace

void throw_usage(const std::string& what) {
  throw UsageError(what + " (--help lists all options)");
}

OptionList::OptionList(const std::string& description, const std::string& usage)
    : app_(std::make_unique<CLI::App>(description, usage)),
      why_extra_([] { return "one argument too many"; }) {
  app_->set_help_flag("-h,--help", "This text");
}

OptionList::~OptionList() = default;

void OptionList::add_text(const std::string& name, std::string& value, const char* type,
                          const std::string& description) {
  app_->add_option(name, value, wrapped(description, kHelpWidth))->type_name(type);
}

void OptionList::add_texts(const std::string& name, std::vector<std::string>& values,
                           const char* type, const std::string& description) {
  app_->add_option(name, values, wrapped(description, kHelpWidth))
      ->type_name(type)
      ->take_all()
      ->expected(1);
}

// Also for numbers: CLI11 reads 010 as 8, -1 as 2^64 - 1 and what is too large as the largest.
void OptionList::add_parsed(const std::string& name, const char* type, const Set& set,
                            const std::string& description) {
  app_->add_option_function<std::string>(name, set, wrapped(description, kHelpWidth))
      ->type_name(type);
}

void OptionList::add_choice(const std::string& name, const std::vector<std::string>& names,
                            const Set& set, const std::string& description) {
  const auto checked = [name, names, set](const std::string& text) {
    check_name(name, text, names);
    set(text);
  };
  add_parsed(name, "NAME", checked, description);
}

void OptionList::add_switch(const std::string& name, bool& value, const std::string& description) {
  app_->add_flag(name, value, wrapped(description, kHelpWidth))->disable_flag_override();
}

std::optional<std::string> OptionList::parse(const Arguments& arguments) {
  try {
    app_->parse(std::vector<std::string>(arguments.values.rbegin(), arguments.values.rend()));
  } catch (const CLI::ExtrasError&) {
    throw_not_expected(app_->remaining().front());
  } catch (const CLI::ArgumentMismatch& error) {
    throw_mismatch(error.what());
  } catch (const CLI::CallForHelp&) {
    return help();
  } catch (const CLI::ParseError& error) {
    throw_usage(error.what());
  }
  return std::nullopt;
}

std::string OptionList::help() const {
  return app_->help() +
         "Exit codes: 0 good, 1 a check failed or an unexpected fault, 2 usage, 3 bad input,\n"
         "4 an output cannot be written, 128 + N stopped by signal N.\n" +
         footer_;
}

std::vector<std::string> OptionList::names() const {
  std::vector<std::string> result;
  for (const CLI::Option* option : app_->get_options())
    for (const std::string& name : option->get_lnames()) result.push_back("--" + name);
  return result;
}

void OptionList::throw_not_expected(const std::string& argument) const {
  if (!argument.starts_with("-")) throw_usage(argument + ": " + why_extra_());
  const std::string name = argument.substr(0, argument.find('='));
  throw_usage(
      fmt::format("{}: no such option; the nearest is {}", name, nearest_name(name, names())));
}

}  // namespace raytracing
