#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

namespace raytracing {

enum class ProgressStyle { automatic, bar, jsonl, none };

std::optional<ProgressStyle> progress_style(std::string_view name);

/// Shows progress on stderr. Says 100 % only when finish() is called.
class ProgressDisplay {
 public:
  /// `automatic` means a bar on a terminal, else nothing.
  explicit ProgressDisplay(ProgressStyle style);

  void update(std::uint64_t done, std::uint64_t total);
  /// Ends the display; `complete` tells whether all samples were taken.
  void finish(bool complete);

 private:
  using Clock = std::chrono::steady_clock;
  void show(double fraction, double seconds) const;

  ProgressStyle style_;
  Clock::time_point start_;
  Clock::time_point shown_;
  double fraction_ = 0;
};

}  // namespace raytracing
