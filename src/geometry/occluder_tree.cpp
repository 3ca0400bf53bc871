#include "raytracing/geometry/occluder_tree.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "raytracing/geometry/embree_api.h"

namespace raytracing {

// Builds the tree by rtcBuildBVH and copies it into the arrays of an OccluderTree.
class OccluderTree::Builder {
 public:
  Builder(OccluderTree& target, std::span<const Vec3> positions,
          std::span<const EmbreeScene::Triangle> triangles, std::span<const std::uint32_t> group)
      : target_(target), positions_(positions), triangles_(triangles), group_(group) {}

  // Fills nodes_ and blocks_ of the target. There must be a triangle.
  void build(int threads);

 private:
  // The tree as Embree's builder makes it, in Embree's allocator. A Branch is an Inner or a Leaf,
  // which is far smaller.
  struct Branch;
  struct Inner;
  struct Leaf;
  struct Counts {
    std::size_t inner = 0, leaves = 0;
  };

  const Branch& build_branches(RTCBVH bvh) const;
  static void count(const Branch& branch, Counts& counts);
  std::uint32_t lay_out(const Branch& branch);
  std::uint32_t add_block(const Leaf& leaf);

  OccluderTree& target_;
  std::span<const Vec3> positions_;
  std::span<const EmbreeScene::Triangle> triangles_;
  std::span<const std::uint32_t> group_;
};

// Embree passes inner nodes and leaves on as void*, so both begin with what tells them apart.
struct OccluderTree::Builder::Branch {
  bool leaf;
  unsigned count;

  template <class Kind>
  static Kind* make(RTCThreadLocalAllocator allocator, bool is_leaf, std::size_t n) {
    static_assert(std::is_base_of_v<Branch, Kind>);
    Kind* branch = new (rtcThreadLocalAlloc(allocator, sizeof(Kind), alignof(Kind))) Kind;
    branch->leaf = is_leaf;
    branch->count = static_cast<unsigned>(n);
    return branch;
  }
};

struct OccluderTree::Builder::Inner : Branch {
  Branch* children[kWidth];
  RTCBounds bounds[kWidth];

  static void* make_inner(RTCThreadLocalAllocator allocator, unsigned n, void*) {
    return static_cast<Branch*>(make<Inner>(allocator, false, n));
  }
  static Inner& of(void* branch) { return static_cast<Inner&>(*static_cast<Branch*>(branch)); }
  static void set_children(void* node, void** children, unsigned n, void*) {
    for (unsigned i = 0; i < n; ++i) of(node).children[i] = static_cast<Branch*>(children[i]);
  }
  static void set_bounds(void* node, const RTCBounds** bounds, unsigned n, void*) {
    for (unsigned i = 0; i < n; ++i) of(node).bounds[i] = *bounds[i];
  }
};

struct OccluderTree::Builder::Leaf : Branch {
  std::uint32_t triangles[kWidth];

  static void* make_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives,
                         std::size_t n, void*) {
    Leaf* leaf = make<Leaf>(allocator, true, n);
    for (std::size_t i = 0; i < n; ++i) leaf->triangles[i] = primitives[i].primID;
    return static_cast<Branch*>(leaf);
  }
};

namespace {

RTCBuildPrimitive to_primitive(const Vec3& a, const Vec3& b, const Vec3& c, unsigned index) {
  const Vec3 lower = glm::min(a, glm::min(b, c));
  const Vec3 upper = glm::max(a, glm::max(b, c));
  return {lower.x, lower.y, lower.z, 0, upper.x, upper.y, upper.z, index};
}

}  // namespace

OccluderTree::OccluderTree(std::span<const Vec3> positions,
                           std::span<const EmbreeScene::Triangle> triangles,
                           std::span<const std::uint32_t> group, std::span<const Sphere> spheres,
                           int threads)
    : built_(true), spheres_(spheres.begin(), spheres.end()) {
  for (const Vec3& v : positions)
    max_coordinate_ = std::max(max_coordinate_, max_component(absolute(v)));
  if (!triangles.empty()) Builder(*this, positions, triangles, group).build(threads);
}

const OccluderTree::Builder::Branch& OccluderTree::Builder::build_branches(RTCBVH bvh) const {
  std::vector<RTCBuildPrimitive> primitives;
  primitives.reserve(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto& c = triangles_[i].corners;
    primitives.push_back(to_primitive(positions_[c[0]], positions_[c[1]], positions_[c[2]],
                                      static_cast<unsigned>(i)));
  }
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.byteSize = sizeof(arguments);
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = kWidth;
  arguments.sahBlockSize = kWidth;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = kWidth;
  // A node costs as much as four blocks: this makes fuller blocks (measured by cost_study).
  arguments.traversalCost = 4;
  arguments.bvh = bvh;
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.capacity();
  arguments.createNode = Inner::make_inner;
  arguments.setNodeChildren = Inner::set_children;
  arguments.setNodeBounds = Inner::set_bounds;
  arguments.createLeaf = Leaf::make_leaf;
  const auto* root = static_cast<const Branch*>(rtcBuildBVH(&arguments));
  if (root == nullptr) throw std::runtime_error("Embree: the occluder tree could not be built");
  return *root;
}

void OccluderTree::Builder::build(int threads) {
  const std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device(
      rtcNewDevice(("threads=" + std::to_string(threads)).c_str()), rtcReleaseDevice);
  const std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> bvh(rtcNewBVH(device.get()),
                                                                rtcReleaseBVH);
  const Branch& root = build_branches(bvh.get());
  Counts counts;
  count(root, counts);
  target_.nodes_.reserve(std::max<std::size_t>(counts.inner, 1));
  target_.blocks_.reserve(counts.leaves);
  if (lay_out(root) & kLeaf) {  // a traversal starts at a node
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

void OccluderTree::Builder::count(const Branch& branch, Counts& counts) {
  ++(branch.leaf ? counts.leaves : counts.inner);
  if (branch.leaf) return;
  for (unsigned i = 0; i < branch.count; ++i)
    count(*static_cast<const Inner&>(branch).children[i], counts);
}

// Stores the branches depth first, each node before its children, so that neighbours in space are
// neighbours in memory. Returns the item that stands for the branch in its parent.
std::uint32_t OccluderTree::Builder::lay_out(const Branch& branch) {
  if (branch.leaf) return kLeaf | add_block(static_cast<const Leaf&>(branch));
  const auto& inner = static_cast<const Inner&>(branch);
  const auto index = static_cast<std::uint32_t>(target_.nodes_.size());
  target_.nodes_.emplace_back();
  Node node{};
  node.count = branch.count;
  for (unsigned i = 0; i < kWidth; ++i) {
    const bool present = i < branch.count;
    const RTCBounds none{1, 1, 1, 0, -1, -1, -1, 0};
    const RTCBounds& b = present ? inner.bounds[i] : none;
    const float corners[2][3] = {{b.lower_x, b.lower_y, b.lower_z},
                                 {b.upper_x, b.upper_y, b.upper_z}};
    for (int side = 0; side < 2; ++side)
      for (int axis = 0; axis < 3; ++axis) node.bounds[side][axis][i] = corners[side][axis];
    if (present) node.children[i] = lay_out(*inner.children[i]);
  }
  target_.nodes_[index] = node;
  return index;
}

std::uint32_t OccluderTree::Builder::add_block(const Leaf& leaf) {
  Block block{};
  for (unsigned i = 0; i < kWidth; ++i) {
    const std::uint32_t triangle = leaf.triangles[i < leaf.count ? i : 0];
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3& v = positions_[triangles_[triangle].corners[i < leaf.count ? corner : 0]];
      for (int axis = 0; axis < 3; ++axis) block.corners[corner][axis][i] = v[axis];
    }
    block.group[i] = group_[triangle];
  }
  target_.blocks_.push_back(block);
  return static_cast<std::uint32_t>(target_.blocks_.size() - 1);
}

}  // namespace raytracing
