#pragma once
// What connects a run with the terminal: text, progress on stderr, and signals.

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

namespace raytracing {

/// Prints to stderr. A stderr that is closed or full is no reason to end a run: the text is lost.
template <class... Values>
void print_message(fmt::format_string<Values...> format, Values&&... values) {
  const std::string text = fmt::format(format, std::forward<Values>(values)...);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

/// Returns "1 light", "2 lights" and so on.
std::string counted(std::uint64_t number, const std::string& noun);

enum class ProgressStyle { automatic, bar, jsonl, none };

/// Shows the progress of a run on stderr. It reaches 100 % only when finish() is called.
class ProgressDisplay {
 public:
  /// `automatic` means a bar if stderr is a terminal, otherwise nothing.
  explicit ProgressDisplay(ProgressStyle style);

  void update(std::uint64_t done, std::uint64_t total);
  /// Ends the display; `complete` is false if the run was stopped early.
  void finish(bool complete);

 private:
  using Clock = std::chrono::steady_clock;
  void show(double fraction, Clock::time_point now) const;

  ProgressStyle style_;
  Clock::time_point start_;
  Clock::time_point shown_;
  double fraction_ = 0;
};

/// While an object of this class lives, SIGINT and SIGTERM request an early end instead of
/// terminating the program. A second signal, at least half a second later, terminates it at once.
/// At most one object lives at a time.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  const std::atomic<bool>& stop() const;
  /// Returns the signal that was received, or 0.
  int signal() const;
};

}  // namespace raytracing
