#pragma once

#include "raytracing/geometry/ray.h"
#include "raytracing/scene/description.h"

namespace raytracing {

/// Pinhole camera for pictures of a given size with square pixels.
class Camera {
 public:
  Camera(const CameraDescription& description, int width, int height);

  /// The ray through (x, y) in pixels; (0,0) is the upper left corner of the picture. Unit
  /// direction.
  Ray ray(float x, float y) const;

 private:
  Vec3 origin_, corner_, step_x_, step_y_;
};

}  // namespace raytracing
