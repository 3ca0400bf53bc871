#include "raytracing/cli/app.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "build_info.h"
#include "commands.h"
#include "options.h"
#include "raytracing/io/errors.h"
#include "terminal.h"

namespace raytracing {
namespace {

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

int run(int argc, char** argv) {
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
