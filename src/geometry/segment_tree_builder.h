#pragma once

#include <memory>

#include "raytracing/geometry/embree_api.h"
#include "raytracing/geometry/segment_visibility.h"

namespace raytracing {

/// Builds the tree of a SegmentVisibility by rtcBuildBVH and lays it out in arrays.
class SegmentVisibility::TreeBuilder {
 public:
  TreeBuilder(SegmentVisibility& target, std::span<const Vec3> positions,
              std::span<const EmbreeScene::Triangle> triangles,
              std::span<const std::uint32_t> group);

  /// Fills nodes_ and blocks_ of the target. There must be a triangle.
  void build(int threads);

 private:
  // What Embree's builder makes: lives in its allocator until it is laid out.
  struct Branch;

  std::uint32_t lay_out(const Branch& branch);
  std::uint32_t add_block(const Branch& leaf);

  SegmentVisibility& target_;
  std::span<const Vec3> positions_;
  std::span<const EmbreeScene::Triangle> triangles_;
  std::span<const std::uint32_t> group_;
};

}  // namespace raytracing
