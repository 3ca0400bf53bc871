#pragma once

#include <vector>

#include "raytracing/scene/scene.h"

namespace raytracing {

/// What happened along one path. Kept for reuse by the next one, whose steps replace these.
struct PathLog {
  struct Step {
    Vec3 position;
    Vec3 normal;
    Rgb throughput;        ///< before this vertex
    Rgb emitted;           ///< throughput times emitted radiance, as counted
    Rgb direct;            ///< throughput times estimated direct light
    std::uint32_t light;   ///< the light that was hit, or kNone
    float survival;        ///< probability of going on: 1 without roulette, 0 where the path ends
  };
  std::vector<Step> steps;
};

}  // namespace raytracing
