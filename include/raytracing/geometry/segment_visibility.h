#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raytracing/geometry/embree_scene.h"
#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/geometry/sphere.h"
#include "raytracing/math/interval_set.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// Exact visibility of a segment from a point: an 8-wide BVH over triangles, built by Embree's
/// public builder and walked here, and a list of spheres. Immutable; queries are thread-safe.
///
/// The triangle (p, a, b = a + d) spans the query. In its plane a point is
/// p + alpha (a-p) + beta (b-p); what lies at alpha, beta >= 0 and alpha + beta < 1 hides the point
/// t = beta / (alpha + beta) of the segment. Triangles cut that plane in segments, so that each
/// hides one interval of t.
class SegmentVisibility {
 public:
  SegmentVisibility() = default;
  /// `group[i]` is the group of triangle i, for leaving groups out of a query; kNone for none.
  SegmentVisibility(std::span<const Vec3> positions,
                    std::span<const EmbreeScene::Triangle> triangles,
                    std::span<const std::uint32_t> group, std::span<const Sphere> spheres,
                    int threads);

  /// The parts within `range` of the segment a + t d, t in [0,1], that are seen from p. Triangles
  /// of the group `skipped` hide nothing; nor does what lies in the query's plane, or at p itself.
  /// A segment whose line runs through p counts as visible.
  IntervalSet visible_part(const Vec3& p, const Vec3& a, const Vec3& d, const Interval& range,
                           std::uint32_t skipped = kNone) const;

  std::size_t node_count() const { return nodes_.size(); }

 private:
  static constexpr int kWidth = 8;
  static constexpr std::uint32_t kLeaf = 0x80000000u;  // marks the index of a block
  // Bounds of up to eight children, coordinate by coordinate: [lower, upper][x, y, z][child].
  // Absent children have lower > upper.
  struct alignas(64) Node {
    float bounds[2][3][kWidth];
    std::uint32_t children[kWidth];  // index into nodes_, or kLeaf | index into blocks_
    std::uint32_t count;
  };
  // Up to eight triangles: [corner][x, y, z][triangle]. A short block repeats its first triangle.
  struct alignas(64) Block {
    float corners[3][3][kWidth];
    std::uint32_t group[kWidth];
  };
  struct Query;
  class TreeBuilder;

  void walk(Query& query, IntervalSet& visible) const;
  void prefetch(std::uint32_t item) const;
  static unsigned children_met(const Node& node, const Query& query);
  static void subtract_block(const Block& block, const Query& query, IntervalSet& visible);

  std::vector<Node> nodes_;
  std::vector<Block> blocks_;
  std::vector<Sphere> spheres_;
  float max_coordinate_ = 0;
};

}  // namespace raytracing
