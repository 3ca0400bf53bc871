#include "terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>

namespace raytracing {
namespace {

constexpr std::chrono::milliseconds kUpdateInterval{200};
constexpr int kBarWidth = 40;
constexpr double kUnfinished = 0.99;  // the largest fraction shown before finish()

// A signal handler can reach nothing but statics; these are the program's only mutable ones.
std::atomic<bool> g_stop{false};
std::atomic<int> g_signal{0};
std::atomic<std::int64_t> g_milliseconds{0};  // when the first signal came
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
              std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t now_milliseconds() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);  // safe in a handler
  return std::int64_t{1000} * t.tv_sec + t.tv_nsec / 1000000;
}

void set_handler(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

// timeout(1) and others signal the process and then its process group: one request, sent twice.
void request_stop(int signal) {
  constexpr std::int64_t kSameRequest = 500;
  const std::int64_t now = now_milliseconds();
  if (g_signal == 0) {
    g_milliseconds = now;
    g_signal = signal;
    g_stop = true;
  } else if (now - g_milliseconds > kSameRequest) {
    set_handler(SIG_DFL);
    raise(signal);
  }
}

}  // namespace

std::string counted(std::uint64_t number, const std::string& noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

ProgressDisplay::ProgressDisplay(ProgressStyle style)
    : style_(style), start_(Clock::now()), shown_(start_) {
  if (style_ == ProgressStyle::automatic)
    style_ = isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::none;
}

void ProgressDisplay::update(std::uint64_t done, std::uint64_t total) {
  fraction_ = std::min(static_cast<double>(done) / static_cast<double>(total), kUnfinished);
  const Clock::time_point now = Clock::now();
  if (style_ == ProgressStyle::none || now - shown_ < kUpdateInterval) return;
  shown_ = now;
  show(fraction_, now);
}

void ProgressDisplay::show(double fraction, Clock::time_point now) const {
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double left = fraction > 0 ? seconds * (1 - fraction) / fraction : 0;
  if (style_ == ProgressStyle::jsonl) {
    print_message("{{\"progress\":{:.4f},\"seconds\":{:.2f},\"seconds_left\":{:.2f}}}\n", fraction,
                  seconds, left);
  } else {
    const int full = static_cast<int>(fraction * kBarWidth);
    print_message("\r[{}{}] {:3.0f} % {:.1f} s, {:.1f} s left   ", std::string(full, '#'),
                  std::string(kBarWidth - full, '.'), 100 * fraction, seconds, left);
  }
  std::fflush(stderr);
}

void ProgressDisplay::finish(bool complete) {
  if (style_ == ProgressStyle::none) return;
  show(complete ? 1 : fraction_, Clock::now());
  if (style_ == ProgressStyle::bar) print_message("\n");
}

StopOnSignal::StopOnSignal() {
  g_stop = false;
  g_signal = 0;
  set_handler(request_stop);
}

StopOnSignal::~StopOnSignal() { set_handler(SIG_DFL); }

const std::atomic<bool>& StopOnSignal::stop() const { return g_stop; }

int StopOnSignal::signal() const { return g_signal; }

}  // namespace raytracing
