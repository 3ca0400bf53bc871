#pragma once

#include <vector>

#include "raytracing/study/stress/cases.h"

namespace raytracing::stress {

/// The cases that sweep the shape, the place or the mesh of an occluder.
std::vector<StressCase> occluder_cases();

}  // namespace raytracing::stress
