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

/// An 8-wide BVH over triangles, built by Embree's public builder, and a list of spheres, for the
/// two questions that are asked many times and that Embree does not take as one: which part of a
/// segment a point sees, and which of many points. Immutable; queries are thread-safe.
class OccluderTree {
 public:
  OccluderTree() = default;
  /// `group[i]` is the group of triangle i, for leaving groups out of a query; kNone for none.
  OccluderTree(std::span<const Vec3> positions, std::span<const EmbreeScene::Triangle> triangles,
               std::span<const std::uint32_t> group, std::span<const Sphere> spheres, int threads);

  /// Exact visibility of a segment: the parts within `range` of a + t d, t in [0,1], that are seen
  /// from p. Triangles of the group `skipped` hide nothing; nor does what lies in the query's
  /// plane, or at p itself. A segment whose line runs through p counts as visible.
  ///
  /// The triangle (p, a, b = a + d) spans the query. In its plane a point is
  /// p + alpha (a-p) + beta (b-p); what lies at alpha, beta >= 0 and alpha + beta < 1 hides the
  /// point t = beta / (alpha + beta) of the segment. Triangles cut that plane in segments, so that
  /// each hides one interval of t.
  IntervalSet visible_part(const Vec3& p, const Vec3& a, const Vec3& d, const Interval& range,
                           std::uint32_t skipped = kNone) const;

  /// Points that are asked about together: arrays of their coordinates.
  struct Targets {
    const float *x, *y, *z;
    int count;  ///< a multiple of 8, at most kMaxTargets
  };
  static constexpr int kMaxTargets = 256;

  /// Sets wanted[k] to 0 for the targets that do not see p, since something lies strictly between;
  /// it is 1 on entry for those that are asked about, at least for one, else 0. All that can hide
  /// any of them meets the shaft (Haines & Wallace 1991), the hull of p and their bounds. Returns
  /// false where it gave up: the tree was not built, or it would take more than `limit` steps, each
  /// a node, a block of triangles, a triangle or a sphere that meets the shaft. Then some of the
  /// targets still wanted may be hidden, too.
  bool keep_visible(const Vec3& p, const Targets& targets, std::int32_t* wanted, int limit) const;

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
  // Up to eight triangles: [corner][x, y, z][triangle]. A short block ends
  // with triangles that are a point.
  struct alignas(64) Block {
    float corners[3][3][kWidth];
    std::uint32_t group[kWidth];
  };
  class TreeBuilder;
  struct SegmentQuery;
  struct Shaft;

  void walk(SegmentQuery& query, IntervalSet& visible) const;
  void prefetch(std::uint32_t item) const;
  static unsigned children_met(const Node& node, const SegmentQuery& query);
  static void subtract_block(const Block& block, const SegmentQuery& query, IntervalSet& visible);

  static unsigned children_met(const Node& node, const Shaft& shaft);
  static bool hide_by_block(const Block& block, Shaft& shaft);
  bool hide_by_spheres(Shaft& shaft) const;

  bool built_ = false;
  std::vector<Node> nodes_;
  std::vector<Block> blocks_;
  std::vector<Sphere> spheres_;
  float max_coordinate_ = 0;
};

}  // namespace raytracing
