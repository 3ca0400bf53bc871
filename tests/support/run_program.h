#pragma once
// Runs the program that was built, as a shell would.

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

extern char** environ;

namespace raytracing {

struct RunResult {
  int exit_code = -1;   ///< 128 + signal when a signal ended the program, as a shell tells it
  bool killed = false;  ///< whether a signal ended it
  std::string out;
  std::string err;
  double seconds = 0;
};

struct RunOptions {
  std::string folder = ".";  ///< working directory
  int signal = 0;            ///< sent `signal_count` times, 2 ms apart; 0 = none
  int signal_count = 1;
  double signal_after = 0;       ///< seconds
  std::string signal_when = "";  ///< send it once this was seen on stderr, then wait signal_after
  double limit = 120;            ///< seconds; then the program is killed and the test fails
};

namespace run_program_detail {

inline void check(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// A pipe whose reading end stays here.
struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() { check(::pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno, "pipe"); }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(int i) {
    if (ends[i] >= 0) ::close(ends[i]);
    ends[i] = -1;
  }
  /// Appends what has come; closes the reading end when no more will.
  void drain(std::string& text) {
    std::array<char, 4096> buffer;
    const ssize_t got = ::read(ends[0], buffer.data(), buffer.size());
    if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
    if (got == 0) close_end(0);
  }
};

inline pid_t spawn(const std::vector<std::string>& arguments, const RunOptions& options, Pipe& out,
                   Pipe& err) {
  std::vector<char*> argv;
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  check(posix_spawn_file_actions_init(&actions), "posix_spawn");
  posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.ends[1], STDERR_FILENO);
  pid_t pid = 0;
  const int error = posix_spawn(&pid, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  check(error, argv[0]);
  out.close_end(1);
  err.close_end(1);
  return pid;
}

}  // namespace run_program_detail

/// Runs any program with its arguments; the first is its path.
inline RunResult run_any(const std::vector<std::string>& arguments,
                         const RunOptions& options = {}) {
  using namespace run_program_detail;
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto since = [](Clock::time_point t) {
    return std::chrono::duration<double>(Clock::now() - t).count();
  };
  Pipe out, err;
  const pid_t pid = spawn(arguments, options, out, err);
  RunResult result;
  bool armed = options.signal != 0, seen = false;
  Clock::time_point seen_at;
  while (out.ends[0] >= 0 || err.ends[0] >= 0) {
    std::array<pollfd, 2> polled{{{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}}};
    ::poll(polled.data(), polled.size(), 5);
    if (polled[0].revents != 0) out.drain(result.out);
    if (polled[1].revents != 0) err.drain(result.err);
    if (!seen && result.err.find(options.signal_when) != std::string::npos) {
      seen = true;
      seen_at = Clock::now();
    }
    if (armed && seen && since(seen_at) >= options.signal_after) {
      armed = false;
      for (int i = 0; i < options.signal_count; ++i) {
        if (i > 0) ::usleep(2000);  // two that wait at the same time would become one
        ::kill(pid, options.signal);
      }
    }
    if (since(start) > options.limit) ::kill(pid, SIGKILL);
  }
  int status = 0;
  if (::waitpid(pid, &status, 0) != pid) throw std::runtime_error("waitpid");
  result.killed = WIFSIGNALED(status);
  result.exit_code = result.killed ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  result.seconds = since(start);
  return result;
}

/// Runs the program of this project.
inline RunResult run_program(std::vector<std::string> arguments, const RunOptions& options = {}) {
  arguments.insert(arguments.begin(), RAYTRACING_PROGRAM);
  return run_any(arguments, options);
}

/// The same in a given working directory.
inline RunResult run_program_in(const std::string& folder, std::vector<std::string> arguments) {
  RunOptions options;
  options.folder = folder;
  return run_program(std::move(arguments), options);
}

}  // namespace raytracing
