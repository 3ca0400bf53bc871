#pragma once
// What numbers of the scene file and of the command line may be.

#include <cstdint>

namespace raytracing {

inline constexpr int kMaxImageSize = 65536;  // pixels, either way
inline constexpr std::uint64_t kMaxSpp = std::uint64_t{1} << 40;

}  // namespace raytracing
