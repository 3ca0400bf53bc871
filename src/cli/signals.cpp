#include "signals.h"

#include <csignal>

namespace raytracing {
namespace {

// A signal handler can reach nothing but statics; these are the program's only mutable ones.
std::atomic<bool> g_stop{false};
std::atomic<int> g_signal{0};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void request_stop(int signal) {
  g_signal = signal;
  g_stop = true;
}

void set_handler(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
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
