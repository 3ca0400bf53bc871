#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "raytracing/geometry/embree_scene.h"
#include "raytracing/geometry/occluder_tree.h"
#include "raytracing/lights/area_light.h"
#include "raytracing/materials/material.h"
#include "raytracing/math/frame.h"
#include "raytracing/scene/description.h"

namespace raytracing {

/// A point of a surface, seen from the direction wo. Normals point to the viewer's side.
struct Vertex {
  Vec3 position;
  float error;    ///< position_error of the surface here
  Vec3 ng;        ///< geometric normal, unit
  Frame shading;  ///< z is the shading normal
  Vec3 wo;        ///< unit, in the shading frame; wo.z > 0
  const Material* material;
  std::uint32_t light;  ///< index of the light this point belongs to and is seen emitting, or kNone
  bool normal_replaced;  ///< ng is the shading normal, the interpolated one turns from the viewer

  /// The origin of a ray that leaves to the viewer's side.
  Vec3 ray_origin() const { return offset_point(position, ng, error); }
};

/// What building a scene found worth telling.
struct BuildNotes {
  std::uint64_t split_lights = 0;      ///< emitting faces not planar and convex, cut into triangles
  std::uint64_t zero_area_lights = 0;  ///< emitting triangles without area, left out as lights
  std::uint64_t averted_lights = 0;    ///< lights with nothing on their emitting side
};

/// The choice of lights is a defensive mixture (Hesterberg 1995): this share of it falls evenly on
/// all lights, the rest in proportion to their powers, so that no weight exceeds the light's own by
/// far where the powerful ones are hidden.
inline constexpr double kEvenLightShare = 0.1;

/// Everything that rendering reads. Immutable after construction.
class Scene {
 public:
  /// `threads` >= 1 build the accelerators. Without `with_occluders`, occluders() stays empty and
  /// takes no memory: for renderings that ask neither for segments nor share paths.
  Scene(SceneDescription description, int threads, bool with_occluders = true);

  const EmbreeScene& geometry() const { return geometry_; }
  const OccluderTree& occluders() const { return occluders_; }
  const CameraDescription& camera() const { return camera_; }
  std::span<const AreaLight> lights() const { return lights_; }
  /// Chooses a light by its power or, with the probability kEvenLightShare, evenly. There must be
  /// one.
  DiscreteDistribution::Choice choose_light(float u) const { return light_choice_.sample(u); }
  std::uint32_t index_of(const AreaLight& light) const {
    return static_cast<std::uint32_t>(&light - lights_.data());
  }
  float light_pmf(std::uint32_t light) const { return light_choice_.pmf(light); }
  const BuildNotes& notes() const { return notes_; }

  Vertex vertex(const Ray& ray, const Hit& hit) const;

 private:
  /// What shading reads of a triangle, in one cache line.
  struct alignas(64) TriangleRecord {
    Vec3 corners[3];
    Vec3 ng;                // unit
    float error;            // position_error
    std::uint32_t surface;  // index into materials_
    std::uint32_t light;    // or kNone
    std::uint32_t normals;  // index into smooth_normals_, or kNone where flat
  };
  struct SmoothNormals {
    Vec3 corners[3];  // unit
  };
  struct Builder;
  // Whether any surface, or the camera, lies on the emitting side of the light's plane.
  bool faces_anything(const AreaLight& light) const;
  Scene(Builder&& builder, int threads, bool with_occluders);

  std::vector<Material> materials_;  // one per surface
  std::vector<std::uint32_t> sphere_materials_;
  std::vector<TriangleRecord> triangles_;
  std::vector<SmoothNormals> smooth_normals_;
  std::vector<AreaLight> lights_;
  DiscreteDistribution light_choice_;
  CameraDescription camera_;
  BuildNotes notes_;
  EmbreeScene geometry_;
  OccluderTree occluders_;
};

// Here for the compiler to make it in place: a copy of a vertex costs more than the vertex.
[[gnu::always_inline]] inline Vertex Scene::vertex(const Ray& ray, const Hit& hit) const {
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
