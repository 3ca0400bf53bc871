#pragma once

namespace raytracing {

/// What a run of the program ends with; a contract with scripts.
enum ExitCode {
  kExitGood = 0,
  kExitCheckFailed = 1,  ///< a result differs, a check failed, or an unexpected fault
  kExitUsage = 2,
  kExitBadInput = 3,
  kExitOutputFailed = 4,
  kExitSignalBase = 128,  ///< plus the signal: 130 after SIGINT, 143 after SIGTERM
};

/// Runs the program: picks the subcommand, and turns every error into one line on stderr and its
/// exit code.
int run(int argc, char** argv);

}  // namespace raytracing
