#include "app.h"

#include <fmt/format.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>

#include "build_info.h"
#include "options.h"
#include "raytracing/io/errors.h"
#include "terminal.h"

namespace raytracing {
namespace {

constexpr std::array kCommands{
    Command{"render", "Render a scene to image files", render_command},
    Command{"compare", "Measure the difference between two images", compare_command},
    Command{"chart", "Measure and plot the error of the direct-light methods over time",
            chart_command},
    Command{"stress", "Test the direct-light methods in difficult cases against exact values",
            stress_command},
};

std::string shell_quoted(std::string_view argument) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
  if (!argument.empty() && argument.find_first_not_of(kPlain) == std::string_view::npos)
    return std::string(argument);
  std::string result = "'";
  for (char c : argument) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

constexpr const char* kStdoutFailed = "standard output: cannot be written";

int run_command(const Invocation& invocation) {
  try {
    return invocation.command->run(invocation.arguments);
  } catch (const TextRequest& request) {
    fmt::print("{}", request.text);
    return kExitGood;
  }
}

int fail(int code, const char* message) noexcept {
  try {
    print_message("Raytracing: {}\n", one_line(message));
  } catch (const std::bad_alloc&) {
    std::fputs("Raytracing: not enough memory\n", stderr);
  }
  return code;
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

Invocation::Invocation(int argc, char** argv)
    : command(&kCommands.front()), arguments{{argv + 1, argv + argc}, ""} {
  // The folder of the program means nothing on the machine that an image reaches.
  arguments.command_line = shell_quoted(std::filesystem::path(argv[0]).filename().string());
  for (const std::string& value : arguments.values)
    arguments.command_line += ' ' + shell_quoted(value);
  for (const Command& c : kCommands) {
    if (arguments.values.empty() || arguments.values.front() != c.name) continue;
    command = &c;
    arguments.values.erase(arguments.values.begin());
    break;
  }
}

int run(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // so that a write beyond a limit fails and is reported
  try {
    if (!is_optimised())
      print_message(
          "Raytracing: WARNING: this build is not optimised and many times slower; configure with "
          "cmake --preset release\n");
    const Invocation invocation(argc, argv);
    const int code = run_command(invocation);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw OutputError(kStdoutFailed);
    return code;
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
