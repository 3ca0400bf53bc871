#include "signals.h"

#include <csignal>
#include <ctime>

namespace raytracing {
namespace {

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

// timeout(1) and others signal the process and then its group: the same wish, told twice.
void request_stop(int signal) {
  constexpr std::int64_t kSameWish = 500;
  const std::int64_t now = now_milliseconds();
  if (g_signal == 0) {
    g_milliseconds = now;
    g_signal = signal;
    g_stop = true;
  } else if (now - g_milliseconds > kSameWish) {
    set_handler(SIG_DFL);
    raise(signal);
  }
}

}  // namespace

StopOnSignal::StopOnSignal() {
  g_stop = false;
  g_signal = 0;
  set_handler(request_stop);
}

StopOnSignal::~StopOnSignal() { set_handler(SIG_DFL); }

const std::atomic<bool>& StopOnSignal::stop() const { return g_stop; }

int StopOnSignal::signal() const { return g_signal; }

}  // namespace raytracing
