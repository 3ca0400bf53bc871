#pragma once

#include <atomic>
#include <cstdint>

namespace raytracing {

/// While it lives, SIGINT and SIGTERM ask for an early end instead of ending the program. A second
/// signal, half a second later or more, ends the program at once. At most one lives at a time.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  const std::atomic<bool>& stop() const;
  /// The signal that came, or 0.
  int signal() const;
};

}  // namespace raytracing
