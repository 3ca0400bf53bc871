#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "raytracing/geometry/embree_scene.h"
#include "raytracing/geometry/occluder_tree.h"
#include "raytracing/lights/area_light.h"
#include "raytracing/materials/material.h"
#include "raytracing/math/vec.h"
#include "raytracing/sampling/discrete.h"
#include "raytracing/scene/description.h"

namespace raytracing {

/// A path vertex: a point of a surface, seen from the direction wo. Both normals point to the side
/// of the viewer.
struct Vertex {
  Vec3 position;
  float error;    ///< position_error of the surface
  Vec3 ng;        ///< geometric normal, unit
  Frame shading;  ///< z is the shading normal
  Vec3 wo;        ///< unit, in the shading frame; wo.z > 0
  const Material* material;
  std::uint32_t light;   ///< index of the light that emits from here to the viewer, or kNone
  bool normal_replaced;  ///< the interpolated normal faced away from the viewer; ng replaces it

  /// Returns the origin of a ray that leaves on the side of the viewer.
  Vec3 ray_origin() const { return offset_point(position, ng, error); }
};

/// Counts of the irregularities found while a scene was built.
struct BuildNotes {
  std::uint64_t split_lights = 0;      ///< emitting faces, not flat or convex, split into triangles
  std::uint64_t zero_area_lights = 0;  ///< emitting triangles of zero area, which are no lights
  /// Lights with neither a surface nor the camera on their emitting side.
  std::uint64_t lights_facing_nothing = 0;
};

/// Lights are sampled from a defensive mixture (Hesterberg 1995): uniformly with this probability,
/// else in proportion to their powers. It bounds the sample weights of weak lights where the
/// powerful ones are occluded.
inline constexpr double kEvenLightShare = 0.1;

/// The scene as the integrators use it. Immutable after construction.
class Scene {
 public:
  /// Builds the acceleration structures with `threads` >= 1 threads. Without `with_occluders`,
  /// occluders() is not built; renderings that do not need it save its memory.
  Scene(SceneDescription description, int threads, bool with_occluders = true);

  const EmbreeScene& geometry() const { return geometry_; }
  const OccluderTree& occluders() const { return occluders_; }
  const CameraDescription& camera() const { return camera_; }
  /// Returns what was subtracted from all positions: see SceneDescription::origin.
  const Vec3& origin() const { return origin_; }
  std::span<const AreaLight> lights() const { return lights_; }
  /// Samples a light by its power or, with the probability kEvenLightShare, uniformly. There must
  /// be one.
  DiscreteDistribution::Choice choose_light(float u) const { return light_choice_.sample(u); }
  std::uint32_t index_of(const AreaLight& light) const {
    return static_cast<std::uint32_t>(&light - lights_.data());
  }
  float light_pmf(std::uint32_t light) const { return light_choice_.pmf(light); }
  const BuildNotes& notes() const { return notes_; }

  /// Returns the vertex at the hit of the ray, seen from the origin of the ray.
  Vertex vertex(const Ray& ray, const Hit& hit) const;

 private:
  /// The data of a triangle for shading, in one cache line.
  struct alignas(64) TriangleRecord {
    Vec3 corners[3];
    Vec3 ng;                // unit
    float error;            // position_error
    std::uint32_t surface;  // index into materials_
    std::uint32_t light;    // index into lights_, or kNone
    std::uint32_t normals;  // index into smooth_normals_, or kNone for a flat triangle
  };
  struct SmoothNormals {
    Vec3 corners[3];  // unit
  };
  struct Builder;
  // Returns true when a surface or the camera lies on the emitting side of the light.
  bool faces_anything(const AreaLight& light) const;
  Scene(Builder&& builder, int threads, bool with_occluders);

  std::vector<Material> materials_;  // one per surface
  std::vector<std::uint32_t> sphere_materials_;
  std::vector<TriangleRecord> triangles_;
  std::vector<SmoothNormals> smooth_normals_;
  std::vector<AreaLight> lights_;
  DiscreteDistribution light_choice_;
  CameraDescription camera_;
  Vec3 origin_;
  BuildNotes notes_;
  EmbreeScene geometry_;
  OccluderTree occluders_;
};

// This body is inline so that the vertex is built in place: copying it would cost more than making
// it.
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
  // Near a silhouette the interpolated normal may face away from the viewer, unlike the geometric
  // normal.
  v.normal_replaced = !(dot(wo, ns) > 0);
  if (v.normal_replaced) ns = v.ng;
  v.shading = Frame::around(ns);
  v.wo = v.shading.to_local(wo);
  return v;
}

}  // namespace raytracing
