#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "raytracing/geometry/embree_api.h"
#include "raytracing/geometry/ray.h"
#include "raytracing/geometry/sphere.h"

namespace raytracing {

/// Where a ray meets the scene first.
struct Hit {
  enum class Kind : std::uint32_t { triangle, sphere };
  Kind kind;
  std::uint32_t index;  ///< of the triangle or the sphere
  float t;              ///< ray parameter
  float u, v;           ///< barycentric weights of a triangle's second and third corner
};

/// Triangles and spheres in an Embree BVH. Immutable once built; queries are thread-safe.
class EmbreeScene {
 public:
  struct Triangle {
    std::uint32_t corners[3];
  };

  /// Takes over the geometry. `threads` >= 1 build the BVH. Throws std::runtime_error with Embree's
  /// message when it reports an error.
  EmbreeScene(std::vector<Vec3> positions, std::vector<Triangle> triangles,
              std::vector<Sphere> spheres, int threads);

  std::optional<Hit> closest_hit(const Ray& ray) const;
  /// The same for up to 8 rays that run much alike, as those of neighbouring pixels do.
  void closest_hits8(std::span<const Ray> rays, std::optional<Hit>* hits) const;
  /// True when something lies strictly between the points `from` and `to`.
  bool occluded(const Vec3& from, const Vec3& to) const;
  /// The same for 8 segments that share the point `from`: bit k tells of the end (x[k], y[k],
  /// z[k]). Only the bits that are set in `wanted` are looked at; the others stay 0.
  unsigned occluded8(const Vec3& from, const float* x, const float* y, const float* z,
                     unsigned wanted) const;

  std::span<const Vec3> positions() const { return {positions_.data(), position_count_}; }
  std::span<const Triangle> triangles() const { return triangles_; }
  std::span<const Sphere> spheres() const { return spheres_; }

 private:
  struct Release {
    void operator()(RTCSceneTy* scene) const;
    void operator()(RTCDeviceTy* device) const;
  };
  static constexpr unsigned kTriangles = 0;  // geometry ids
  static constexpr unsigned kSpheres = 1;
  static std::optional<Hit> found(unsigned geometry, unsigned primitive, float t, float u, float v);
  void add_triangles();
  void add_spheres();

  // Shared with Embree, which reads 16 bytes from each position: the vector has one more.
  std::vector<Vec3> positions_;
  std::size_t position_count_;
  std::vector<Triangle> triangles_;
  std::vector<Sphere> spheres_;
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

// Here for the compiler to keep rays and hits in registers.

inline std::optional<Hit> EmbreeScene::found(unsigned geometry, unsigned primitive, float t,
                                             float u, float v) {
  if (geometry == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return Hit{geometry == kTriangles ? Hit::Kind::triangle : Hit::Kind::sphere, primitive, t, u, v};
}

inline std::optional<Hit> EmbreeScene::closest_hit(const Ray& ray) const {
  RTCRayHit query;
  query.ray = embree::ray(ray.origin, ray.direction, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect1(scene_.get(), query);
  return found(query.hit.geomID, query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v);
}

inline bool EmbreeScene::occluded(const Vec3& from, const Vec3& to) const {
  RTCRay query = embree::ray(from, to - from, 1.0f);
  embree::occluded1(scene_.get(), query);
  return query.tfar < 0;
}

/// "Embree 3.13.5", as compiled against.
const char* embree_version();

}  // namespace raytracing
