#pragma once

#include <cstddef>
#include <vector>

#include "raytracing/scene/scene.h"

namespace raytracing {

/// What happened along one path. Kept for reuse by the next one, whose steps replace these.
struct PathLog {
  struct Step {
    Vec3 position;
    Vec3 normal;
    Rgb throughput;       ///< before this vertex
    Rgb emitted;          ///< throughput times emitted radiance, as counted
    Rgb direct;           ///< throughput times estimated direct light
    std::uint32_t light;  ///< the light that was hit, or kNone
    float survival;       ///< probability of going on: 1 without roulette, 0 where the path ends
  };
  std::vector<Step> steps;
};

/// What first became infinite or not a number along a path.
enum class NonFiniteCause {
  geometry,      ///< a position or a normal
  bsdf,          ///< the throughput: weights of BSDF sampling and of roulette
  emission,      ///< the emission of a light that the path met, as weighted
  direct_light,  ///< a direct-light estimate; its light, BSDF and density cannot be told apart
  sum,           ///< no single one of these: their sum overflowed
};
inline constexpr std::size_t kNonFiniteCauses = 5;

/// The cause for the path of a sample whose radiance is not finite.
NonFiniteCause non_finite_cause(const PathLog& log);

/// "geometry", "bsdf", "emission", "direct_light" or "sum".
const char* to_string(NonFiniteCause cause);

}  // namespace raytracing
