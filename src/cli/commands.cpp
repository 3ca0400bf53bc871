#include "commands.h"

#include <array>
#include <filesystem>

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

}  // namespace raytracing
