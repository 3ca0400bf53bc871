#include "raytracing/scene/description.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "raytracing/math/numeric.h"

namespace raytracing {
namespace {

// A scene is far where its distance from the origin exceeds this multiple of half its size. Its
// coordinates then differ by less than a factor of 2, and their differences are exact (Sterbenz
// 1974).
constexpr float kFar = 4;

struct Bounds {
  Vec3 low{std::numeric_limits<float>::infinity()};
  Vec3 high{-std::numeric_limits<float>::infinity()};

  void add(const Vec3& p, float radius = 0) {
    low = glm::min(low, p - radius);
    high = glm::max(high, p + radius);
  }
};

Bounds bounds_of(const SceneDescription& scene) {
  Bounds bounds;
  for (const PolygonMesh& mesh : scene.meshes)
    for (const Vec3& p : mesh.positions) bounds.add(p);
  for (const SphereDescription& s : scene.spheres) bounds.add(s.center, s.radius);
  return bounds;
}

}  // namespace

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

Recentering find_recentering(const SceneDescription& scene) {
  const auto [low, high] = bounds_of(scene);
  const float half = max_component(high - low) / 2;
  Recentering result;
  if (!std::isfinite(half)) return result;
  for (int i = 0; i < 3; ++i) {
    const float middle = low[i] + (high[i] - low[i]) / 2;
    if (!(std::abs(middle) > kFar * half)) continue;
    result.origin[i] = middle;
    const float size = std::abs(middle);
    const float spacing = std::nextafter(size, std::numeric_limits<float>::infinity()) - size;
    result.rounding = std::max(result.rounding, half > 0 ? spacing / half : 0.0f);
  }
  return result;
}

void recenter(SceneDescription& scene, const Vec3& origin) {
  for (PolygonMesh& mesh : scene.meshes)
    for (Vec3& p : mesh.positions) p -= origin;
  for (SphereDescription& s : scene.spheres) s.center -= origin;
  scene.camera.origin -= origin;
  scene.camera.target -= origin;
  scene.origin += origin;
}

}  // namespace raytracing
