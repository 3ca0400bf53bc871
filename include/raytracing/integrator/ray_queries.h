#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "raytracing/scene/scene.h"

namespace raytracing {

/// What one thread has asked of the accelerators.
struct RayCounts {
  std::uint64_t closest = 0;   ///< closest-hit rays
  std::uint64_t shadow = 0;    ///< occlusion tests
  std::uint64_t segments = 0;  ///< exact visibility queries of a segment
  std::uint64_t shafts = 0;    ///< shaft queries that found which of many points see one
  std::uint64_t escaped = 0;   ///< closest-hit rays from a surface that met nothing
  /// Light samples taken uniform in area by a method that is uniform in solid angle, where the
  /// solid angle is too small or too large for float arithmetic.
  std::uint64_t area_fallbacks = 0;

  RayCounts& operator+=(const RayCounts& other) {
    closest += other.closest;
    shadow += other.shadow;
    segments += other.segments;
    shafts += other.shafts;
    escaped += other.escaped;
    area_fallbacks += other.area_fallbacks;
    return *this;
  }
};

/// The questions that transport asks about the scene, counted. One per thread.
class RayQueries {
 public:
  explicit RayQueries(const Scene& scene) : scene_(scene) {}

  std::optional<Hit> closest_hit(const Ray& ray) {
    ++counts_.closest;
    return scene_.geometry().closest_hit(ray);
  }

  /// closest_hit of up to 8 rays that run much alike.
  void closest_hits8(std::span<const Ray> rays, std::optional<Hit>* hits) {
    counts_.closest += rays.size();
    scene_.geometry().closest_hits8(rays, hits);
  }

  /// Whether something stands between the vertex and the point `q` of the light.
  bool occluded(const Vertex& v, const Vec3& q, const AreaLight& light) {
    ++counts_.shadow;
    // Of a far vertex, the ray's end is known only as well as the vertex's own coordinates.
    const Vec3 end = offset_point(q, light.normal, std::max(light.error, v.error));
    return scene_.geometry().occluded(v.ray_origin(), end);
  }

  /// Of the 8 ray origins (x[k], y[k], z[k]), those wanted (bits) that do not see the ray origin
  /// `from`.
  unsigned occluded8(const Vec3& from, const float* x, const float* y, const float* z,
                     unsigned wanted) {
    counts_.shadow += static_cast<unsigned>(std::popcount(wanted));
    return scene_.geometry().occluded8(from, x, y, z, wanted);
  }

  /// OccluderTree::keep_visible of targets that are ray origins, from the ray origin `from`.
  bool keep_visible(const Vec3& from, const OccluderTree::Targets& targets, std::int32_t* wanted,
                    int limit) {
    const bool answered = scene_.occluders().keep_visible(from, targets, wanted, limit);
    if (answered) ++counts_.shafts;
    return answered;
  }

  /// The parts of the chord, within `range`, that the vertex sees; parameters of the chord.
  IntervalSet visible_part(const Vertex& v, const Chord& chord, const Interval& range,
                           const AreaLight& light) {
    ++counts_.segments;
    const Vec3 off_light = std::max(light.error, v.error) * light.normal;
    return scene_.occluders().visible_part(v.ray_origin(), chord.begin + off_light,
                                           chord.length * chord.direction, range,
                                           scene_.index_of(light));
  }

  void count_escaped() { ++counts_.escaped; }
  void count_area_fallback() { ++counts_.area_fallbacks; }

  const RayCounts& counts() const { return counts_; }

 private:
  const Scene& scene_;
  RayCounts counts_;
};

}  // namespace raytracing
