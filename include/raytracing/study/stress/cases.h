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

/// A small scene whose exact radiance along one ray is known.
struct StressScene {
  struct Light {
    std::vector<Vec3> corners;  ///< planar and convex
    float Le;
  };

  SceneDescription scene;
  Ray ray;  ///< meets the receiver from a short distance
  std::optional<std::uint32_t> max_depth = 1;
  /// The exact radiance is computed from these, stated apart from the scene: the lights, and convex
  /// polygons whose union throws the shadow.
  std::vector<Light> lights;
  std::vector<std::vector<Vec3>> occluders;
  /// The radiance where it is known otherwise; then lights and occluders are not used.
  std::optional<double> radiance;
  /// Whether the scene's camera renders it in the default mode, by groups of 16 x 16 pixels that
  /// share paths. All pixels must have the radiance along `ray`.
  bool shares_paths = false;
};

/// One setting of a case's parameter.
struct StressSetting {
  std::string label;  ///< the parameter's value, as a short text
  std::function<StressScene()> make;
};

/// A sweep of one parameter towards trouble.
struct StressCase {
  std::string_view name;
  std::string_view family;     ///< cases of one family share a picture
  std::string_view parameter;  ///< the parameter that is swept
  std::string_view truth;      ///< the source of the exact radiance
  std::vector<StressSetting> settings;
};

/// All cases, those of a family one after the other.
std::span<const StressCase> stress_cases();

std::vector<std::string> stress_case_names();

}  // namespace raytracing
