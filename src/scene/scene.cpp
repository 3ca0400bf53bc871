#include "raytracing/scene/scene.h"

#include <cmath>
#include <utility>

#include "scene_builder.h"

namespace raytracing {

Scene::Scene(SceneDescription description, int threads, bool with_segments)
    : Scene(Builder(std::move(description)), threads, with_segments) {}

Scene::Scene(Builder&& b, int threads, bool with_segments)
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
  light_choice_ = DiscreteDistribution(powers);
  if (!with_segments) return;
  std::vector<std::uint32_t> light_of_triangle;
  for (const TriangleRecord& t : triangles_) light_of_triangle.push_back(t.light);
  segments_ = SegmentVisibility(geometry_.positions(), geometry_.triangles(), light_of_triangle,
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

Vertex Scene::vertex(const Ray& ray, const Hit& hit) const {
  Vertex v;
  Vec3 ns;
  v.light = kNone;
  if (hit.kind == Hit::Kind::triangle) {
    const TriangleRecord& t = triangles_[hit.index];
    const float w = 1 - hit.u - hit.v;
    v.position = w * t.corners[0] + hit.u * t.corners[1] + hit.v * t.corners[2];
    v.error = t.error;
    v.ng = t.ng;
    v.material = &materials_[t.surface];
    if (t.normals == kNone) {
      ns = t.ng;
    } else {
      const SmoothNormals& n = smooth_normals_[t.normals];
      ns = normalize(w * n.corners[0] + hit.u * n.corners[1] + hit.v * n.corners[2]);
    }
    v.light = t.light;
  } else {
    const Sphere& s = geometry_.spheres()[hit.index];
    v.ng = normalize(ray.origin + hit.t * ray.direction - s.center);
    v.position = s.center + s.radius * v.ng;
    v.error = position_error(s.max_coordinate());
    v.material = &materials_[sphere_materials_[hit.index]];
    ns = v.ng;
  }

  const Vec3 wo = -normalize(ray.direction);
  if (dot(wo, v.ng) < 0) {
    v.ng = -v.ng;
    ns = -ns;
    v.light = kNone;
  }
  // An interpolated normal may turn away from the viewer near a silhouette; the true one does not.
  v.normal_replaced = !(dot(wo, ns) > 0);
  if (v.normal_replaced) ns = v.ng;
  v.shading = Frame::around(ns);
  v.wo = v.shading.to_local(wo);
  return v;
}

}  // namespace raytracing
