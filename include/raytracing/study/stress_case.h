#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/scene/scene.h"

namespace raytracing {

/// A small scene of which the exact radiance along one ray is known.
struct StressScene {
  struct Light {
    std::vector<Vec3> corners;  ///< planar and convex
    float Le;
  };

  SceneDescription scene;
  Ray ray;  ///< meets the receiver, from near by
  std::optional<std::uint32_t> max_depth = 1;
  /// What the truth is computed from, stated apart from the scene: the lights, and convex polygons
  /// whose union throws the shadow.
  std::vector<Light> lights;
  std::vector<std::vector<Vec3>> occluders;
  /// The radiance where it is known otherwise; then lights and occluders are not asked.
  std::optional<double> radiance;
};

/// One setting of a case's parameter.
struct StressSetting {
  std::string label;  ///< of the parameter's value, short
  double value;
  std::function<StressScene()> make;
};

/// A sweep of one parameter towards trouble.
struct StressCase {
  std::string_view name;
  std::string_view family;     ///< cases of one family share a picture
  std::string_view parameter;  ///< what is swept, for people
  std::string_view truth;      ///< where the exact radiance comes from
  std::vector<StressSetting> settings;
};

/// All cases, those of a family one after the other.
std::span<const StressCase> stress_cases();

std::vector<std::string> stress_case_names();

}  // namespace raytracing
