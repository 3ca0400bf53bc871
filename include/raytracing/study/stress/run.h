#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "raytracing/study/stress/result.h"

namespace raytracing {

/// The cases and methods to measure, and how thoroughly.
struct StressPlan {
  std::vector<const StressCase*> cases;
  std::vector<const DirectMethod*> methods;
  std::uint64_t seeds = 4;  ///< kPixelsPerSeed pixels each
  int line_rays = 4;
  int threads = 1;
};

inline constexpr int kPixelsPerSeed = 256;

/// Measures every method at every setting; a measurement that looks biased is repeated with four
/// times as many other pixels. Threads take one setting after the other. `progress` receives the
/// number of settings done and of all, from one thread at a time.
StressResult run_stress(const StressPlan& plan, const std::atomic<bool>& stop,
                        const std::function<void(std::uint64_t, std::uint64_t)>& progress = {});

}  // namespace raytracing
