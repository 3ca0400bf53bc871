#pragma once
// The program and its subcommands. Each of these is defined in the source file of its name.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raytracing {

/// The exit codes of the program, a contract with scripts.
enum ExitCode {
  kExitGood = 0,
  kExitCheckFailed = 1,  ///< a result differs, a check failed, or an unexpected error
  kExitUsage = 2,
  kExitBadInput = 3,
  kExitOutputFailed = 4,
  kExitSignalBase = 128,  ///< plus the signal: 130 after SIGINT, 143 after SIGTERM
};

/// Runs the program. Every error becomes one line on stderr and an exit code.
int run(int argc, char** argv);

/// The command line of a subcommand.
struct Arguments {
  std::vector<std::string> values;  ///< without the names of the program and the subcommand
  std::string command_line;         ///< as a shell accepts it; recorded in the outputs
};

/// A row of the table of subcommands.
struct Command {
  std::string_view name;
  std::string_view summary;
  /// Returns the exit code. Throws UsageError, InputError, OutputError and TextRequest.
  int (*run)(const Arguments&);
};

/// All subcommands; the first one runs if the command line names none.
std::span<const Command> commands();

/// Splits the command line of the program into a subcommand and its arguments.
struct Invocation {
  Invocation(int argc, char** argv);
  const Command* command;
  Arguments arguments;
};

/// Renders a scene to image files.
int render_command(const Arguments& arguments);

/// Compares two images.
int compare_command(const Arguments& arguments);

/// Measures the error of the direct-light methods against time.
int chart_command(const Arguments& arguments);

/// Measures the direct-light methods against exact radiances. Returns kExitCheckFailed if a method
/// that is documented as unbiased is biased, or a sample is not finite.
int stress_command(const Arguments& arguments);

}  // namespace raytracing
