#include "raytracing/scene/far_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raytracing {
namespace {

// Of the distance from the origin over half the scene's size. The coordinates then differ by less
// than a factor of 2, and their differences are exact (Sterbenz 1974).
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

FarPlace far_place(const SceneDescription& scene) {
  const auto [low, high] = bounds_of(scene);
  const float half = max_component(high - low) / 2;
  FarPlace place;
  if (!std::isfinite(half)) return place;
  for (int i = 0; i < 3; ++i) {
    const float middle = low[i] + (high[i] - low[i]) / 2;
    if (!(std::abs(middle) > kFar * half)) continue;
    place.origin[i] = middle;
    const float size = std::abs(middle);
    const float spacing = std::nextafter(size, std::numeric_limits<float>::infinity()) - size;
    place.rounding = std::max(place.rounding, half > 0 ? spacing / half : 0.0f);
  }
  return place;
}

void move_scene(SceneDescription& scene, const Vec3& origin) {
  for (PolygonMesh& mesh : scene.meshes)
    for (Vec3& p : mesh.positions) p -= origin;
  for (SphereDescription& s : scene.spheres) s.center -= origin;
  scene.camera.origin -= origin;
  scene.camera.target -= origin;
}

}  // namespace raytracing
