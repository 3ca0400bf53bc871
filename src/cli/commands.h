#pragma once
// The subcommands, one source file each.

#include <string>
#include <vector>

namespace raytracing {

/// Arguments of a subcommand, without program and subcommand names; `command_line` is the whole
/// line as given, for the headers of the pictures.
struct Arguments {
  std::vector<std::string> values;
  std::string command_line;
};

/// The table of subcommands, one a line, for the help.
std::string subcommands_text();

/// The subcommand with the name most like this one.
std::string nearest_subcommand(const std::string& name);

/// Renders a scene to pictures. Returns the exit code; throws UsageError, InputError, OutputError.
int render_command(const Arguments& arguments);

/// Compares two pictures. Returns and throws as render_command() does.
int compare_command(const Arguments& arguments);

/// Measures the methods' error against time. As above.
int chart_command(const Arguments& arguments);

/// Measures the methods where they might fail, against exact truth. As above; kExitCheckFailed when
/// a method that claims to be unbiased is not, or a sample is not finite.
int stress_command(const Arguments& arguments);

}  // namespace raytracing
