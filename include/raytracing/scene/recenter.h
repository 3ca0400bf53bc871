#pragma once

#include "raytracing/scene/description.h"

namespace raytracing {

/// The translation that moves a scene to the origin of coordinates. A scene needs it when it is
/// small compared to its distance from the origin: floats then still tell its points apart, but
/// have too few digits for the rays between them.
struct Recentering {
  /// The new origin, for each coordinate within the bounds of the scene, or 0 where the scene is
  /// near enough. The positions of the scene minus this point are exact in float.
  Vec3 origin{0.0f};
  /// The spacing of floats at the scene relative to half its size, or 0 where it is near enough.
  float rounding = 0;
};

/// Finds the recentering from the bounds of the meshes and spheres.
Recentering find_recentering(const SceneDescription& scene);

/// Subtracts `origin` from all positions, including those of the camera.
void recenter(SceneDescription& scene, const Vec3& origin);

}  // namespace raytracing
