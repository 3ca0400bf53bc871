#pragma once

#include <vector>

#include "raytracing/study/stress/cases.h"

namespace raytracing::stress {

/// The cases of the receiver's surface, and of the surfaces that light it.
std::vector<StressCase> surface_cases();

}  // namespace raytracing::stress
