#pragma once
// What else numbers on the command line may be, and the command line's default of threads.

#include <algorithm>
#include <cstdint>
#include <thread>

#include "raytracing/scene/limits.h"

namespace raytracing {

inline constexpr std::uint64_t kMaxReplicates = 65536;
inline constexpr int kMaxThreads = 1024;
inline constexpr int kMaxLineRays = 65536;
inline constexpr std::uint64_t kMaxDepth = std::uint64_t{1} << 30;

/// As many as the machine has.
inline int default_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace raytracing
