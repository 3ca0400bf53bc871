#pragma once

#include "raytracing/scene/description.h"

namespace raytracing {

/// Where a scene lies that is small for its distance from the origin of coordinates. There, floats
/// tell its points apart, but have no digits left for rays between them.
struct FarPlace {
  /// A point of the scene's bounds, coordinate by coordinate; 0 where the scene lies near enough.
  /// Positions of the scene minus it are exact in float.
  Vec3 origin{0.0f};
  float rounding = 0;  ///< spacing of the floats there over half the scene's size; 0 where near
};

/// Of meshes and spheres.
FarPlace far_place(const SceneDescription& scene);

/// Subtracts `origin` from all positions, those of the camera too.
void move_scene(SceneDescription& scene, const Vec3& origin);

}  // namespace raytracing
