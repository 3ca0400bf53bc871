#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "raytracing/geometry/ray.h"
#include "raytracing/geometry/sphere.h"

struct RTCSceneTy;
struct RTCDeviceTy;

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

/// "Embree 3.13.5", as compiled against.
const char* embree_version();

}  // namespace raytracing
