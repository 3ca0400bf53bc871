#pragma once

#include <string>
#include <vector>

#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/materials/material.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// A named surface: how it reflects and what it emits.
struct Surface {
  std::string name;
  Material material;
  Rgb Le{0.0f};  ///< radiance emitted on the normal side of a face, >= 0
};

struct SphereDescription {
  Vec3 center{0.0f};
  float radius = 1;
  std::uint32_t surface = 0;  ///< index into SceneDescription::surfaces; must not emit
};

/// Pinhole camera. Its picture is upright: up points to the top row, and with `origin` in front of
/// the picture's plane, right is cross(target - origin, up).
struct CameraDescription {
  Vec3 origin{0.0f, 0.0f, 1.0f};
  Vec3 target{0.0f};
  Vec3 up{0.0f, 1.0f, 0.0f};
  float vertical_fov = 40;  ///< degrees, in (0,180)
};

/// What a scene file says, before any acceleration structure is built. Plain data.
struct SceneDescription {
  std::vector<Surface> surfaces;
  std::vector<PolygonMesh> meshes;  ///< in world space; Face::material indexes `surfaces`
  std::vector<SphereDescription> spheres;
  CameraDescription camera;
};

}  // namespace raytracing
