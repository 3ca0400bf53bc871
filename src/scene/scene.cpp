#include "raytracing/scene/scene.h"

#include <cmath>
#include <utility>

#include "scene_builder.h"

namespace raytracing {
namespace {

DiscreteDistribution choice_by(std::vector<float> powers) {
  double sum = 0;
  for (const float power : powers) sum += static_cast<double>(power);
  const double even =
      sum / static_cast<double>(powers.size()) * kEvenLightShare / (1 - kEvenLightShare);
  for (float& power : powers) power += static_cast<float>(even);
  return DiscreteDistribution(powers);
}

}  // namespace

Scene::Scene(SceneDescription description, int threads, bool with_occluders)
    : Scene(Builder(std::move(description)), threads, with_occluders) {}

Scene::Scene(Builder&& b, int threads, bool with_occluders)
    : materials_(std::move(b.materials)),
      sphere_materials_(std::move(b.sphere_materials)),
      triangles_(std::move(b.records)),
      smooth_normals_(std::move(b.smooth_normals)),
      lights_(std::move(b.lights)),
      camera_(b.camera),
      notes_(b.notes),
      geometry_(std::move(b.positions), std::move(b.triangles), std::move(b.spheres), threads) {
  std::vector<float> powers;
  for (const AreaLight& light : lights_) {
    powers.push_back(light.power());
    if (!faces_anything(light)) ++notes_.averted_lights;
  }
  light_choice_ = choice_by(std::move(powers));
  if (!with_occluders) return;
  std::vector<std::uint32_t> light_of_triangle;
  for (const TriangleRecord& t : triangles_) light_of_triangle.push_back(t.light);
  occluders_ = OccluderTree(geometry_.positions(), geometry_.triangles(), light_of_triangle,
                            geometry_.spheres(), threads);
}

bool Scene::faces_anything(const AreaLight& light) const {
  constexpr float kRoundings = 8;
  const auto is_in_front = [&](const Vec3& p, float radius) {
    return dot(p - light.corners[0], light.normal) + radius > kRoundings * light.error;
  };
  if (is_in_front(camera_.origin, 0)) return true;
  for (const Vec3& p : geometry_.positions())
    if (is_in_front(p, 0)) return true;
  for (const Sphere& s : geometry_.spheres())
    if (is_in_front(s.center, s.radius)) return true;
  return false;
}

}  // namespace raytracing
