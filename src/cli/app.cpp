#include "raytracing/cli/app.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>

#include "build_info.h"
#include "commands.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/nearest_name.h"

namespace raytracing {
namespace {

struct Command {
  std::string_view name;
  std::string_view summary;
  int (*run)(const Arguments&);
};

// The first one is what runs when no command is named.
constexpr std::array kCommands{
    Command{"render", "renders a scene to pictures", render_command},
    Command{"compare", "tells how far a picture is from another, and where", compare_command},
    Command{"chart", "measures the error of the methods against their time, and draws it",
            chart_command},
    Command{"stress", "looks for where the methods fail, against exact truth", stress_command},
};

constexpr const char* kStdoutFailed = "standard output: cannot be written";

// As a shell would take it again.
std::string quoted(std::string_view argument) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
  if (!argument.empty() && argument.find_first_not_of(kPlain) == std::string_view::npos)
    return std::string(argument);
  std::string result = "'";
  for (char c : argument) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

int dispatch(int argc, char** argv) {
  Arguments arguments;
  // Where the program lies on this machine is of no use to whom the picture reaches.
  const std::string program = std::filesystem::path(argv[0]).filename().string();
  arguments.command_line = quoted(std::string_view(program));
  for (int i = 1; i < argc; ++i) arguments.command_line += ' ' + quoted(argv[i]);
  arguments.values.assign(argv + 1, argv + argc);
  const Command* chosen = &kCommands.front();
  for (const Command& command : kCommands) {
    if (arguments.values.empty() || arguments.values.front() != command.name) continue;
    chosen = &command;
    arguments.values.erase(arguments.values.begin());
    break;
  }
  const int code = chosen->run(arguments);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw OutputError(kStdoutFailed);
  return code;
}

int fail(int code, const std::string& message) {
  fmt::print(stderr, "Raytracing: {}\n", one_line(message));
  return code;
}

}  // namespace

std::string subcommands_text() {
  std::string text =
      "Subcommands (the first one's name may be left out; each has its own --help):\n";
  for (const Command& command : kCommands)
    text += fmt::format("{:<12} {}\n", command.name, command.summary);
  return text + "\n";
}

std::string nearest_subcommand(const std::string& name) {
  std::vector<std::string> names;
  for (const Command& command : kCommands) names.emplace_back(command.name);
  return nearest_name(name, names);
}

int run(int argc, char** argv) {
  if (!is_optimised())
    fmt::print(stderr,
               "Raytracing: WARNING: built without optimisation; it runs many times slower. "
               "Configure with cmake --preset release.\n");
  try {
    return dispatch(argc, argv);
  } catch (const UsageError& error) {
    return fail(kExitUsage, error.what());
  } catch (const InputError& error) {
    return fail(kExitBadInput, error.what());
  } catch (const OutputError& error) {
    return fail(kExitOutputFailed, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kExitCheckFailed, "not enough memory");
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return fail(kExitOutputFailed, kStdoutFailed);
    return fail(kExitCheckFailed, error.what());
  }
}

}  // namespace raytracing
