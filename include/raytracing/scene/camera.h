#pragma once

#include "raytracing/geometry/shapes.h"
#include "raytracing/scene/description.h"

namespace raytracing {

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

}  // namespace raytracing
