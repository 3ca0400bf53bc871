#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "raytracing/geometry/embree_api.h"
#include "raytracing/geometry/shapes.h"

namespace raytracing {

/// The closest intersection of a ray with the scene.
struct Hit {
  enum class Kind : std::uint32_t { triangle, sphere };
  Kind kind;
  std::uint32_t index;  ///< index of the triangle or the sphere
  float t;              ///< ray parameter
  float u, v;           ///< barycentric weights of the second and third corner of a triangle
};

/// Triangles and spheres in an Embree BVH. Immutable once built; queries are thread-safe.
class EmbreeScene {
 public:
  struct Triangle {
    std::uint32_t corners[3];
  };

  /// Takes ownership of the geometry and builds the BVH with `threads` >= 1 threads. Throws
  /// std::runtime_error with the message of Embree when it reports an error.
  EmbreeScene(std::vector<Vec3> positions, std::vector<Triangle> triangles,
              std::vector<Sphere> spheres, int threads);

  /// Returns the closest hit, or nothing when the ray leaves the scene.
  std::optional<Hit> closest_hit(const Ray& ray) const;
  /// Finds the closest hits of up to 8 coherent rays, such as those of neighbouring pixels.
  void closest_hits8(std::span<const Ray> rays, std::optional<Hit>* hits) const;
  /// Returns true when something lies strictly between the points `from` and `to`.
  bool occluded(const Vec3& from, const Vec3& to) const;
  /// Tests 8 segments that share the point `from`. Bit k of the result is set when the end (x[k],
  /// y[k], z[k]) is occluded. Only the segments whose bits are set in `wanted` are tested; the
  /// other bits are 0.
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

  // Embree reads 16 bytes at each position, so this vector has one position more.
  std::vector<Vec3> positions_;
  std::size_t position_count_;
  std::vector<Triangle> triangles_;
  std::vector<Sphere> spheres_;
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

// These bodies are inline so that the compiler keeps rays and hits in registers.

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

/// Returns the version that the program was compiled against, for example "Embree 3.13.5".
const char* embree_version();

}  // namespace raytracing
