#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/geometry/shapes.h"
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

/// The largest width and height of an image, in pixels.
inline constexpr int kMaxImageSize = 65536;

/// A pinhole camera for an image of a given size with square pixels.
class Camera {
 public:
  Camera(const CameraDescription& description, int width, int height);

  /// Returns the ray through the point (x, y) of the image, with a unit direction. The coordinates
  /// are in pixels from the upper left corner.
  Ray ray(float x, float y) const;

 private:
  Vec3 origin_, corner_, step_x_, step_y_;
};

/// The content of a scene file, before any acceleration structure is built.
struct SceneDescription {
  std::vector<Surface> surfaces;
  std::vector<PolygonMesh> meshes;  ///< in world space; Face::material indexes `surfaces`
  std::vector<SphereDescription> spheres;
  CameraDescription camera;
  /// What recenter() has subtracted from all positions: a position plus this is that of the file.
  Vec3 origin{0.0f};
};

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

/// Subtracts `origin` from all positions, including those of the camera, and adds it to the scene's
/// own `origin`.
void recenter(SceneDescription& scene, const Vec3& origin);

}  // namespace raytracing
