#pragma once

#include <string>
#include <vector>

#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/materials/material.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// A named surface with its reflectance and emission.
struct Surface {
  std::string name;
  Material material;
  Rgb Le{0.0f};  ///< radiance emitted on the side of the normal, >= 0
};

struct SphereDescription {
  Vec3 center{0.0f};
  float radius = 1;
  std::uint32_t surface = 0;  ///< index into SceneDescription::surfaces, which must not emit
};

/// A pinhole camera. `up` points towards the top row of the image, and
/// cross(target - origin, up) points to the right.
struct CameraDescription {
  Vec3 origin{0.0f, 0.0f, 1.0f};
  Vec3 target{0.0f};
  Vec3 up{0.0f, 1.0f, 0.0f};
  float vertical_fov = 40;  ///< degrees, in (0,180)
};

/// The content of a scene file, before any acceleration structure is built.
struct SceneDescription {
  std::vector<Surface> surfaces;
  std::vector<PolygonMesh> meshes;  ///< in world space; Face::material indexes `surfaces`
  std::vector<SphereDescription> spheres;
  CameraDescription camera;
};

}  // namespace raytracing
