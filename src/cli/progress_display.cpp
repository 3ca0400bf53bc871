#include "progress_display.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace raytracing {
namespace {

constexpr std::chrono::milliseconds kBetweenUpdates{200};
constexpr int kBarWidth = 40;

}  // namespace

std::optional<ProgressStyle> progress_style(std::string_view name) {
  if (name == "auto") return ProgressStyle::automatic;
  if (name == "bar") return ProgressStyle::bar;
  if (name == "jsonl") return ProgressStyle::jsonl;
  if (name == "none") return ProgressStyle::none;
  return std::nullopt;
}

ProgressDisplay::ProgressDisplay(ProgressStyle style)
    : style_(style), start_(Clock::now()), shown_(start_) {
  if (style_ == ProgressStyle::automatic)
    style_ = isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::none;
}

void ProgressDisplay::update(std::uint64_t done, std::uint64_t total) {
  fraction_ = static_cast<double>(done) / static_cast<double>(total);
  const Clock::time_point now = Clock::now();
  if (style_ == ProgressStyle::none || now - shown_ < kBetweenUpdates) return;
  shown_ = now;
  show(std::min(fraction_, 0.99), std::chrono::duration<double>(now - start_).count());
}

void ProgressDisplay::show(double fraction, double seconds) const {
  const double left = fraction > 0 ? seconds * (1 - fraction) / fraction : 0;
  if (style_ == ProgressStyle::jsonl) {
    fmt::print(stderr, "{{\"progress\":{:.4f},\"seconds\":{:.2f},\"seconds_left\":{:.2f}}}\n",
               fraction, seconds, left);
  } else {
    const int full = static_cast<int>(fraction * kBarWidth);
    fmt::print(stderr, "\r[{}{}] {:3.0f} % {:.1f} s, {:.1f} s left   ", std::string(full, '#'),
               std::string(kBarWidth - full, '.'), 100 * fraction, seconds, left);
  }
  std::fflush(stderr);
}

void ProgressDisplay::finish(bool complete) {
  if (style_ == ProgressStyle::none) return;
  show(complete ? 1 : std::min(fraction_, 0.99),
       std::chrono::duration<double>(Clock::now() - start_).count());
  if (style_ == ProgressStyle::bar) fmt::print(stderr, "\n");
}

}  // namespace raytracing
