#pragma once

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

}  // namespace raytracing
