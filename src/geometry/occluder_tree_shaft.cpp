// OccluderTree::keep_visible: which of many points are visible from one point.

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "float8.h"
#include "raytracing/geometry/occluder_tree.h"

namespace raytracing {
namespace {

// The relative tolerance of comparisons of bounds. It exceeds their rounding error by little, so
// that few more boxes and triangles pass.
constexpr float kTolerance = 0x1p-20f;
// The relative rounding error of the side of an edge on which a target lies.
constexpr float kRounding = 0x1p-22f;

Points operator+(const Points& a, const Points& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Points operator-(const Points& a, const Points& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Points operator-(const Points& a) { return {-a.x, -a.y, -a.z}; }
Points absolute(const Points& a) { return {simd::abs(a.x), simd::abs(a.y), simd::abs(a.z)}; }
Float8 dot(const Points& a, const Points& b) { return a.x * b.x + (a.y * b.y + a.z * b.z); }
Points cross(const Points& a, const Points& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Points broadcast(const Vec3& v) { return {v.x, v.y, v.z}; }

// Eight triangles as seen from p. A triangle whose plane does not contain p occludes the target d
// where plane.d > depth and edges[i].d <= 0 for all three edges.
struct TrianglePlanes {
  Points edges[3];
  Points plane;
  Float8 depth;  // 0 when the triangle is degenerate or its plane contains p, else > 0

  explicit TrianglePlanes(const Points (&v)[3]) {
    // The two triangles of an edge get exactly opposite normals, with fused operations too, so that
    // no light leaks between them (Davidovic et al. 2012).
    for (int i = 0; i < 3; ++i) {
      const Points &from = v[i], &to = v[(i + 1) % 3];
      edges[i] = cross(to - from, to + from);
    }
    // The plane is computed from the two shorter edges. The edges that meet at the tip of a needle
    // are nearly parallel, and rounding would tilt their plane.
    const Points sides[3] = {v[1] - v[0], v[2] - v[1], v[0] - v[2]};
    const Float8 lengths2[3] = {dot(sides[0], sides[0]), dot(sides[1], sides[1]),
                                dot(sides[2], sides[2])};
    const Mask8 first_longest = lengths2[0] >= lengths2[1] && lengths2[0] >= lengths2[2];
    const Mask8 second_longest = !first_longest && lengths2[1] >= lengths2[2];
    const auto opposite = [&](const Points& of_first, const Points& of_second,
                              const Points& of_third) {
      return select(first_longest, of_first, select(second_longest, of_second, of_third));
    };
    plane = cross(opposite(sides[1], sides[2], sides[0]), opposite(sides[2], sides[0], sides[1]));
    depth = dot(plane, opposite(v[2], v[0], v[1]));
    const Mask8 turned = depth < 0;
    depth = simd::abs(depth);
    for (Points* normal : {&edges[0], &edges[1], &edges[2], &plane})
      *normal = select(turned, -*normal, *normal);
  }
};

}  // namespace

struct OccluderTree::Shaft {
  Shaft(const Vec3& from, const Targets& targets, std::int32_t* wanted, int max_steps);

  // Clears the targets that triangle i occludes.
  void occlude(const TrianglePlanes& planes, int i);
  bool anything_wanted() const {
    std::int32_t any = 0;
    for (int k = 0; k < count; ++k) any |= still[k];
    return any != 0;
  }
  Vec3 target(int k) const { return {x[k], y[k], z[k]}; }

  Vec3 p;
  int count;
  std::int32_t* still;  // 1 for targets that are wanted and not found occluded, else 0
  int steps;            // number of steps that are left
  Vec3 centre, half;    // bounds of the targets, relative to p
  // The cross-section of the shaft at the fraction t of its length is [t lower, t upper] in each
  // coordinate, with the bounds of the targets. These are the inverses of the bounds.
  Vec3 inverse_lower, inverse_upper;
  alignas(64) float x[kMaxTargets], y[kMaxTargets], z[kMaxTargets];  // targets, from p
};

OccluderTree::Shaft::Shaft(const Vec3& from, const Targets& targets, std::int32_t* wanted,
                           int max_steps)
    : p(from), count(targets.count), still(wanted), steps(max_steps) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (int k = 0; k < count; ++k) {
    x[k] = targets.x[k] - p.x;
    y[k] = targets.y[k] - p.y;
    z[k] = targets.z[k] - p.z;
  }
  const float* const coordinates[3] = {x, y, z};
  for (int axis = 0; axis < 3; ++axis) {
    alignas(64) float low[kMaxTargets], high[kMaxTargets];  // of wanted targets only
    for (int k = 0; k < count; ++k) {
      low[k] = still[k] != 0 ? coordinates[axis][k] : kInfinity;
      high[k] = still[k] != 0 ? coordinates[axis][k] : -kInfinity;
    }
    Float8 lowest = kInfinity, highest = -kInfinity;
    for (int k = 0; k < count; k += kLanes) {
      lowest = simd::min(lowest, load(low + k));
      highest = simd::max(highest, load(high + k));
    }
    const float lower = simd::hmin(lowest), upper = simd::hmax(highest);
    centre[axis] = 0.5f * (lower + upper);
    half[axis] = 0.5f * (upper - lower);
    // The smallest normal number replaces 0 as a divisor.
    constexpr float kMin = std::numeric_limits<float>::min();
    inverse_lower[axis] = 1 / (std::abs(lower) < kMin ? -kMin : lower);
    inverse_upper[axis] = 1 / (std::abs(upper) < kMin ? kMin : upper);
  }
}

void OccluderTree::Shaft::occlude(const TrianglePlanes& planes, int i) {
  const auto normal = [i](const Points& n) { return Vec3(n.x[i], n.y[i], n.z[i]); };
  const Vec3 a = normal(planes.edges[0]), b = normal(planes.edges[1]), c = normal(planes.edges[2]);
  const Vec3 n = normal(planes.plane);
  const float depth = planes.depth[i];
  // Bounds how far rounding may move a ray across an edge. With a smaller bound, rays towards a
  // corner that many triangles share might miss them all.
  const Vec3 size = absolute(centre) + half;
  const auto rounding = [&](const Vec3& edge) { return kRounding * dot(absolute(edge), size); };
  const float off_a = rounding(a), off_b = rounding(b), off_c = rounding(c);
  for (int k = 0; k < count; ++k) {
    const auto along = [&](const Vec3& v) { return v.x * x[k] + (v.y * y[k] + v.z * z[k]); };
    const bool inside =
        std::max(along(a) - off_a, std::max(along(b) - off_b, along(c) - off_c)) <= 0;
    still[k] &= !(inside & (along(n) > depth));
  }
}

unsigned OccluderTree::intersected_children(const Node& node, const Shaft& shaft) {
  // The fractions of the length of the shaft between which its cross-section overlaps the box.
  Float8 first = 0.0f, last = 1.0f;
  for (int axis = 0; axis < 3; ++axis) {
    const Float8 lower = load(node.bounds[0][axis]) - shaft.p[axis];
    const Float8 upper = load(node.bounds[1][axis]) - shaft.p[axis];
    const Float8 reaches = lower * shaft.inverse_upper[axis];  // where t upper(shaft) = lower(box)
    const Float8 leaves = upper * shaft.inverse_lower[axis];   // where t lower(shaft) = upper(box)
    if (shaft.inverse_upper[axis] > 0)
      first = simd::max(first, reaches);
    else
      last = simd::min(last, reaches);
    if (shaft.inverse_lower[axis] > 0)
      last = simd::min(last, leaves);
    else
      first = simd::max(first, leaves);
  }
  const Mask8 met = first * (1 - kTolerance) <= last * (1 + kTolerance);
  return to_bits(met) & ((1u << node.count) - 1);
}

bool OccluderTree::occlude_by_block(const Block& block, Shaft& shaft) {
  Points corners[3];
  for (int i = 0; i < 3; ++i)
    corners[i] = {load(block.corners[i][0]) - shaft.p.x, load(block.corners[i][1]) - shaft.p.y,
                  load(block.corners[i][2]) - shaft.p.z};
  const TrianglePlanes planes(corners);
  const Points centre = broadcast(shaft.centre), half = broadcast(shaft.half);
  const Points size = broadcast(absolute(shaft.centre) + shaft.half);
  // Nothing is occluded when all targets lie on the outer side of one plane. For targets that lie
  // on the triangle itself any answer is within rounding, so their own faces cost no test of each
  // target.
  const auto reach = [&](const Points& n) { return dot(absolute(n), half); };
  Mask8 met = planes.depth > 0 && dot(planes.plane, centre) + reach(planes.plane) > planes.depth;
  for (const Points& edge : planes.edges)
    met = met && dot(edge, centre) - reach(edge) <= kTolerance * dot(absolute(edge), size);
  for (unsigned bits = to_bits(met); bits != 0; bits &= bits - 1) {
    if (shaft.steps-- == 0) return false;
    shaft.occlude(planes, std::countr_zero(bits));
  }
  return true;
}

// A sphere intersects the shaft only if the distance of its centre from the axis of the shaft is at
// most the sum of both radii.
bool OccluderTree::occlude_by_spheres(Shaft& shaft) const {
  const float radius = length(shaft.half);
  for (const Sphere& sphere : spheres_) {
    const Vec3 centre = sphere.center - shaft.p;
    const float t = dot(centre, shaft.centre) / dot(shaft.centre, shaft.centre);
    const Vec3 nearest = t > 0 ? std::min(t, 1.0f) * shaft.centre : Vec3(0.0f);
    const float reach = (radius + sphere.radius) * (1 + kTolerance) + kTolerance * length(centre);
    if (length(centre - nearest) > reach) continue;
    if (shaft.steps-- == 0) return false;
    for (int k = 0; k < shaft.count; ++k) {
      const auto [t0, t1] = line_crossings(sphere, Ray{shaft.p, shaft.target(k)});
      shaft.still[k] &= !(((t0 > 0) & (t0 < 1)) | ((t1 > 0) & (t1 < 1)));
    }
  }
  return true;
}

bool OccluderTree::keep_visible(const Vec3& p, const Targets& targets, std::int32_t* wanted,
                                int limit) const {
  assert(targets.count % kLanes == 0 && targets.count <= kMaxTargets);
  if (!built_) return false;
  Shaft shaft(p, targets, wanted, limit);
  if (!occlude_by_spheres(shaft)) return false;
  std::uint32_t stack[kStackSize];
  int size = 0;
  if (!nodes_.empty()) stack[size++] = 0;
  while (size > 0) {
    if (shaft.steps-- == 0) return false;
    const std::uint32_t item = stack[--size];
    if ((item & kLeaf) == 0) {
      const Node& node = nodes_[item];
      for (unsigned met = intersected_children(node, shaft); met != 0; met &= met - 1) {
        const std::uint32_t child = node.children[std::countr_zero(met)];
        prefetch(child);
        stack[size++] = child;
      }
      continue;
    }
    const int before = shaft.steps;
    if (!occlude_by_block(blocks_[item & ~kLeaf], shaft)) return false;
    if (shaft.steps != before && !shaft.anything_wanted()) return true;
  }
  return true;
}

}  // namespace raytracing
