#include "segment_tree_builder.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace raytracing {

struct SegmentVisibility::TreeBuilder::Branch {
  bool leaf;
  unsigned count;
  Branch* children[kWidth];           // of an inner branch
  RTCBounds bounds[kWidth];           // of the children
  std::uint32_t triangles[kWidth];    // of a leaf

  static void* make(RTCThreadLocalAllocator allocator, bool is_leaf, unsigned n) {
    void* memory = rtcThreadLocalAlloc(allocator, sizeof(Branch), alignof(Branch));
    Branch* branch = new (memory) Branch;
    branch->leaf = is_leaf;
    branch->count = n;
    return branch;
  }
  static void* make_inner(RTCThreadLocalAllocator allocator, unsigned n, void*) {
    return make(allocator, false, n);
  }
  static void* make_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives,
                         std::size_t n, void*) {
    Branch* leaf = static_cast<Branch*>(make(allocator, true, static_cast<unsigned>(n)));
    for (std::size_t i = 0; i < n; ++i) leaf->triangles[i] = primitives[i].primID;
    return leaf;
  }
  static void set_children(void* node, void** children, unsigned n, void*) {
    for (unsigned i = 0; i < n; ++i)
      static_cast<Branch*>(node)->children[i] = static_cast<Branch*>(children[i]);
  }
  static void set_bounds(void* node, const RTCBounds** bounds, unsigned n, void*) {
    for (unsigned i = 0; i < n; ++i) static_cast<Branch*>(node)->bounds[i] = *bounds[i];
  }
};

namespace {

RTCBuildPrimitive to_primitive(const Vec3& a, const Vec3& b, const Vec3& c, unsigned index) {
  const Vec3 lower = glm::min(a, glm::min(b, c));
  const Vec3 upper = glm::max(a, glm::max(b, c));
  return {lower.x, lower.y, lower.z, 0, upper.x, upper.y, upper.z, index};
}

}  // namespace

SegmentVisibility::TreeBuilder::TreeBuilder(SegmentVisibility& target,
                                            std::span<const Vec3> positions,
                                            std::span<const EmbreeScene::Triangle> triangles,
                                            std::span<const std::uint32_t> group)
    : target_(target), positions_(positions), triangles_(triangles), group_(group) {}

void SegmentVisibility::TreeBuilder::build(int threads) {
  std::vector<RTCBuildPrimitive> primitives;
  primitives.reserve(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto& c = triangles_[i].corners;
    primitives.push_back(to_primitive(positions_[c[0]], positions_[c[1]], positions_[c[2]],
                                      static_cast<unsigned>(i)));
  }
  const std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device(
      rtcNewDevice(("threads=" + std::to_string(threads)).c_str()), rtcReleaseDevice);
  const std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> bvh(rtcNewBVH(device.get()),
                                                                rtcReleaseBVH);
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.byteSize = sizeof(arguments);
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = kWidth;
  arguments.sahBlockSize = kWidth;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = kWidth;
  arguments.traversalCost = 4;  // of a node, in blocks: fuller blocks, measured by cost_study
  arguments.bvh = bvh.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.capacity();
  arguments.createNode = Branch::make_inner;
  arguments.setNodeChildren = Branch::set_children;
  arguments.setNodeBounds = Branch::set_bounds;
  arguments.createLeaf = Branch::make_leaf;
  const auto* root = static_cast<const Branch*>(rtcBuildBVH(&arguments));
  if (root == nullptr) throw std::runtime_error("Embree: the segment tree could not be built");
  if (lay_out(*root) & kLeaf) {  // a walk begins at a node
    Node node{};
    node.count = 1;
    node.children[0] = kLeaf;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < kWidth; ++i) {
        node.bounds[0][axis][i] = (i == 0 ? -1 : 1) * std::numeric_limits<float>::max();
        node.bounds[1][axis][i] = (i == 0 ? 1 : -1) * std::numeric_limits<float>::max();
      }
    target_.nodes_.push_back(node);
  }
}

// Depth first, a node before its children: neighbours in space are neighbours in memory.
std::uint32_t SegmentVisibility::TreeBuilder::lay_out(const Branch& branch) {
  if (branch.leaf) return kLeaf | add_block(branch);
  const auto index = static_cast<std::uint32_t>(target_.nodes_.size());
  target_.nodes_.emplace_back();
  Node node{};
  node.count = branch.count;
  for (unsigned i = 0; i < kWidth; ++i) {
    const bool present = i < branch.count;
    const RTCBounds none{1, 1, 1, 0, -1, -1, -1, 0};
    const RTCBounds& b = present ? branch.bounds[i] : none;
    const float corners[2][3] = {{b.lower_x, b.lower_y, b.lower_z},
                                 {b.upper_x, b.upper_y, b.upper_z}};
    for (int side = 0; side < 2; ++side)
      for (int axis = 0; axis < 3; ++axis) node.bounds[side][axis][i] = corners[side][axis];
    if (present) node.children[i] = lay_out(*branch.children[i]);
  }
  target_.nodes_[index] = node;
  return index;
}

std::uint32_t SegmentVisibility::TreeBuilder::add_block(const Branch& leaf) {
  Block block{};
  for (unsigned i = 0; i < kWidth; ++i) {
    const std::uint32_t triangle = leaf.triangles[i < leaf.count ? i : 0];
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3& v = positions_[triangles_[triangle].corners[corner]];
      for (int axis = 0; axis < 3; ++axis) block.corners[corner][axis][i] = v[axis];
    }
    block.group[i] = group_[triangle];
  }
  target_.blocks_.push_back(block);
  return static_cast<std::uint32_t>(target_.blocks_.size() - 1);
}

}  // namespace raytracing
