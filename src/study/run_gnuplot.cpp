#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include "raytracing/io/errors.h"
#include "raytracing/study/chart_plot.h"

extern char** environ;

namespace raytracing {

// No shell takes part, so that the folder may have any name.
bool run_gnuplot(const std::string& folder, const std::string& script) {
  std::string program = "gnuplot", file = script;
  const std::array<char*, 3> argv{program.data(), file.data(), nullptr};
  posix_spawn_file_actions_t actions;
  if (posix_spawn_file_actions_init(&actions) != 0) throw OutputError("gnuplot: cannot be started");
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  // In a group of its own, or the terminal's Ctrl-C would end it in the midst of a picture.
  posix_spawnattr_t attributes;
  if (posix_spawnattr_init(&attributes) != 0) throw OutputError("gnuplot: cannot be started");
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  pid_t pid = 0;
  const int error = posix_spawnp(&pid, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) return false;
  if (error != 0)
    throw OutputError("gnuplot: cannot be started: " + std::generic_category().message(error));
  int status = 0;
  while (waitpid(pid, &status, 0) < 0)
    if (errno != EINTR) throw OutputError("gnuplot: its end was not seen");
  if (status != 0) throw OutputError(fmt::format("gnuplot failed on {}/{}", folder, script));
  return true;
}

}  // namespace raytracing
