#pragma once
// What numbers on the command line may be.

#include <algorithm>
#include <cstdint>
#include <thread>

namespace raytracing {

inline constexpr int kMaxImageSize = 65536;
inline constexpr std::uint64_t kMaxSpp = std::uint64_t{1} << 40;
inline constexpr std::uint64_t kMaxReplicates = 65536;
inline constexpr int kMaxThreads = 1024;
inline constexpr int kMaxLineRays = 65536;
inline constexpr std::uint64_t kMaxDepth = std::uint64_t{1} << 30;

/// As many as the machine has.
inline int default_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace raytracing
