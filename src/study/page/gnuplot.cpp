#include "raytracing/study/page/gnuplot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "raytracing/io/errors.h"

extern char** environ;

namespace raytracing {

std::string gnuplot_string(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

std::string gnuplot_array(const std::string& name, const std::vector<std::string>& texts) {
  std::vector<std::string> constants;
  for (const std::string& text : texts) constants.push_back(gnuplot_string(text));
  return fmt::format("array {}[{}] = [{}]\n", name, texts.size(), fmt::join(constants, ", "));
}

// No shell takes part, so that any name of the folder works.
bool run_gnuplot(const std::string& folder, const std::string& script) {
  std::string program = "gnuplot", file = script;
  const std::array<char*, 3> argv{program.data(), file.data(), nullptr};
  posix_spawn_file_actions_t actions;
  if (posix_spawn_file_actions_init(&actions) != 0) throw OutputError("gnuplot: cannot be started");
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  // It runs in a process group of its own, or Ctrl-C on the terminal would end it in the middle of
  // a picture.
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
    if (errno != EINTR) throw OutputError("gnuplot: waiting for its end failed");
  if (status != 0) throw OutputError(fmt::format("gnuplot failed on {}/{}", folder, script));
  return true;
}

}  // namespace raytracing
