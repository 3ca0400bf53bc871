#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raytracing/geometry/embree_scene.h"
#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/geometry/shapes.h"
#include "raytracing/math/interval_set.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// An 8-wide BVH over triangles, built by Embree's public builder, and a list of spheres. It
/// answers two frequent visibility queries that Embree offers only ray by ray: which part of a
/// segment is visible from a point, and which of many points are. Immutable; queries are
/// thread-safe.
class OccluderTree {
 public:
  OccluderTree() = default;
  /// `group[i]` is the group of triangle i, or kNone; a query can ignore one group. `threads` >= 1
  /// build the tree. Throws std::runtime_error when Embree fails.
  OccluderTree(std::span<const Vec3> positions, std::span<const EmbreeScene::Triangle> triangles,
               std::span<const std::uint32_t> group, std::span<const Sphere> spheres, int threads);

  /// Returns the exact visible part of a segment: the parameters t within `range`, itself within
  /// [0,1], for which a + t d is visible from p. Triangles of the group `skipped`, triangles in the
  /// plane of the query and triangles through p do not occlude. A segment whose line passes through
  /// p counts as visible. Throws std::logic_error when the tree was not built.
  ///
  /// The query is the triangle (p, a, b = a + d). A point of its plane is p + alpha (a-p) +
  /// beta (b-p); where alpha, beta >= 0 and alpha + beta < 1, it occludes the point
  /// t = beta / (alpha + beta) of the segment. A triangle of the scene intersects the plane in a
  /// line segment and thus occludes one interval of t.
  IntervalSet visible_part(const Vec3& p, const Vec3& a, const Vec3& d, const Interval& range,
                           std::uint32_t skipped = kNone) const;

  /// The points of one query, as arrays of their coordinates.
  struct Targets {
    const float *x, *y, *z;
    int count;  ///< a multiple of 8, at most kMaxTargets
  };
  static constexpr int kMaxTargets = 256;

  /// Sets wanted[k] to 0 for each target k that is occluded from p. On entry wanted[k] is 1 for the
  /// targets to be tested, of which there must be one, and 0 for the others. All possible occluders
  /// intersect the shaft (Haines & Wallace 1991), the convex hull of p and the bounds of the
  /// targets. Returns false when the query gave up, and then some of the targets still wanted may
  /// be occluded: the tree was not built, or the query would take more than `limit` steps. A step
  /// is a node, a block of triangles, or a triangle or sphere that intersects the shaft.
  bool keep_visible(const Vec3& p, const Targets& targets, std::int32_t* wanted, int limit) const;

 private:
  static constexpr int kWidth = 8;
  static constexpr std::uint32_t kLeaf = 0x80000000u;  // marks the index of a block
  // Embree's builder stops at depth 32, then splits evenly.
  static constexpr int kStackSize = kWidth * 64;
  // The bounds of up to eight children as [lower, upper][x, y, z][child]. Absent children have
  // lower > upper.
  struct alignas(64) Node {
    float bounds[2][3][kWidth];
    std::uint32_t children[kWidth];  // index into nodes_, or kLeaf | index into blocks_
    std::uint32_t count;
  };
  // Up to eight triangles as [corner][x, y, z][triangle]. Triangles that shrank to a point fill the
  // rest of a block.
  struct alignas(64) Block {
    float corners[3][3][kWidth];
    std::uint32_t group[kWidth];
  };
  class Builder;
  struct SegmentQuery;
  struct Shaft;

  void prefetch(std::uint32_t item) const;

  void traverse(SegmentQuery& query, IntervalSet& visible) const;
  static unsigned intersected_children(const Node& node, const SegmentQuery& query);
  static void subtract_shadows(const Block& block, const SegmentQuery& query, IntervalSet& visible);

  static unsigned intersected_children(const Node& node, const Shaft& shaft);
  static bool occlude_by_block(const Block& block, Shaft& shaft);
  bool occlude_by_spheres(Shaft& shaft) const;

  bool built_ = false;
  std::vector<Node> nodes_;
  std::vector<Block> blocks_;
  std::vector<Sphere> spheres_;
  float max_coordinate_ = 0;
};

}  // namespace raytracing
