#include "raytracing/scene/camera.h"

#include <cmath>

#include "raytracing/math/numeric.h"

namespace raytracing {

Camera::Camera(const CameraDescription& d, int width, int height) : origin_(d.origin) {
  const Vec3 forward = normalize(d.target - d.origin);
  const Vec3 right = normalize(cross(forward, d.up));
  const Vec3 up = cross(right, forward);
  const float half_height = std::tan(d.vertical_fov * (kPi / 360));
  const float pixel = 2 * half_height / static_cast<float>(height);
  step_x_ = pixel * right;
  step_y_ = -pixel * up;
  corner_ = forward - 0.5f * static_cast<float>(width) * step_x_ -
            0.5f * static_cast<float>(height) * step_y_;
}

Ray Camera::ray(float x, float y) const {
  return {origin_, normalize(corner_ + x * step_x_ + y * step_y_)};
}

}  // namespace raytracing
