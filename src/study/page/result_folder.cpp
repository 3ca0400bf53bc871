#include "raytracing/study/page/result_folder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"

extern char** environ;

namespace raytracing {

ResultFolder::ResultFolder(std::string path, Announce announce)
    : path_(std::move(path)), announce_(std::move(announce)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw OutputError(path_ + ": " + error.message());
}

void ResultFolder::write(const std::string& name, const std::string& bytes) const {
  write_file(path_ + "/" + name, bytes);
  announce_(name);
}

bool ResultFolder::draw(const std::string& script, const std::vector<std::string>& pictures) const {
  if (!run_gnuplot(path_, script)) return false;
  for (const std::string& name : pictures) announce_(name);
  return true;
}

std::vector<std::string> picture_files(const std::vector<std::string>& plots) {
  std::vector<std::string> files;
  for (const std::string& plot : plots)
    for (const char* extension : {".svg", ".png"}) files.push_back(plot + extension);
  return files;
}

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
