#pragma once

#include <memory>

#include "raytracing/geometry/embree_api.h"
#include "raytracing/geometry/occluder_tree.h"

namespace raytracing {

/// Builds the tree of an OccluderTree by rtcBuildBVH and lays it out in arrays.
class OccluderTree::TreeBuilder {
 public:
  TreeBuilder(OccluderTree& target, std::span<const Vec3> positions,
              std::span<const EmbreeScene::Triangle> triangles,
              std::span<const std::uint32_t> group);

  /// Fills nodes_ and blocks_ of the target. There must be a triangle.
  void build(int threads);

 private:
  // What Embree's builder makes: lives in its allocator until it is laid out. A Branch is an Inner
  // or a Leaf, which is far smaller.
  struct Branch;
  struct Inner;
  struct Leaf;
  struct Counts {
    std::size_t inner = 0, leaves = 0;
  };

  const Branch& make_branches(RTCBVH bvh) const;
  static void count(const Branch& branch, Counts& counts);
  std::uint32_t lay_out(const Branch& branch);
  std::uint32_t add_block(const Leaf& leaf);

  OccluderTree& target_;
  std::span<const Vec3> positions_;
  std::span<const EmbreeScene::Triangle> triangles_;
  std::span<const std::uint32_t> group_;
};

}  // namespace raytracing
