#include "raytracing/geometry/segment_visibility.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <experimental/simd>

#include "segment_tree_builder.h"
#include "sphere_shadow.h"

namespace raytracing {
namespace {

namespace simd = std::experimental;
constexpr int kLanes = 8;
using Lanes = simd::simd<float, simd::simd_abi::deduce_t<float, kLanes>>;
using Mask = Lanes::mask_type;
Lanes load(const float (&values)[kLanes]) { return Lanes(values, simd::vector_aligned); }

unsigned to_bits(const Mask& mask) {
  unsigned bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= static_cast<unsigned>(mask[i]) << i;
  return bits;
}

// n . x for eight points.
Lanes dot(const Vec3& n, const Lanes& x, const Lanes& y, const Lanes& z) {
  return n.x * x + (n.y * y + n.z * z);
}

[[gnu::always_inline]] inline Lanes select(const Mask& mask, const Lanes& yes, const Lanes& no) {
  Lanes result = no;
  simd::where(mask, result) = yes;
  return result;
}

// Eight points of the query's plane, in its two coordinates. Their sum is kept besides, 0 at p and
// 1 on the segment: for a short far segment alpha and beta are large and cancel in it.
struct PlanePoints {
  Lanes alpha, beta, depth;
  Lanes t() const { return beta / (alpha + beta); }  // exactly 0 or 1 after a clip
};

[[gnu::always_inline]] inline PlanePoints select(const Mask& mask, const PlanePoints& yes,
                                                 const PlanePoints& no) {
  return {select(mask, yes.alpha, no.alpha), select(mask, yes.beta, no.beta),
          select(mask, yes.depth, no.depth)};
}

[[gnu::always_inline]] inline PlanePoints mix(const PlanePoints& a, const PlanePoints& b,
                                              const Lanes& s) {
  return {a.alpha + s * (b.alpha - a.alpha), a.beta + s * (b.beta - a.beta),
          a.depth + s * (b.depth - a.depth)};
}

// Eight points of space, from p.
struct Points {
  Lanes x, y, z;
};

[[gnu::always_inline]] inline Points select(const Mask& mask, const Points& yes,
                                            const Points& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

// One corner of eight triangles and its signed distance from the plane.
struct Corners {
  Points at;
  Lanes e;
};

// Where the edges between a and b meet the plane. Always from the corner that is nearer to it, or,
// of two as near, from the side e >= 0: the two triangles that share an edge get the same point, and
// nothing shines through between them. In space, and from the nearer corner: where the segment is
// near, the plane's coordinates of corners far from it are large, and so is the rounding of the
// corners' own places; it would be that of t.
[[gnu::always_inline]] inline Points crossing(const Corners& a, const Corners& b) {
  const Mask a_first = (a.e >= 0) == (a.e + b.e <= 0);  // the signs of the two differ
  const Points first = select(a_first, a.at, b.at), second = select(a_first, b.at, a.at);
  const Lanes e_first = select(a_first, a.e, b.e), e_second = select(a_first, b.e, a.e);
  const Lanes s = e_first / (e_first - e_second);
  return {first.x + s * (second.x - first.x), first.y + s * (second.y - first.y),
          first.z + s * (second.z - first.z)};
}

// Whether the planes of eight triangles, with corners given from p, separate p from some of the
// segment from a to b. What does not hides nothing: the receiver's own face, a few roundings behind
// p, would else count where the light is far and alpha and beta are known only to such roundings.
Mask separates(const Lanes (&x)[3], const Lanes (&y)[3], const Lanes (&z)[3], const Vec3& a,
               const Vec3& b) {
  const Lanes ux = x[1] - x[0], uy = y[1] - y[0], uz = z[1] - z[0];
  const Lanes vx = x[2] - x[0], vy = y[2] - y[0], vz = z[2] - z[0];
  const Lanes nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  const auto side = [&](const Vec3& q) {
    return nx * (q.x - x[0]) + (ny * (q.y - y[0]) + nz * (q.z - z[0]));
  };
  const Lanes of_p = side(Vec3(0.0f)), of_a = side(a), of_b = side(b);
  return !((of_p > 0 && of_a > 0 && of_b > 0) || (of_p < 0 && of_a < 0 && of_b < 0));
}

// Cuts the plane segments from c to d where the function that has these values at their ends is
// negative; `coordinate`, if any, is that function and becomes exactly 0 at the cut. Returns which
// segments are gone altogether.
[[gnu::always_inline]] inline Mask clip(PlanePoints& c, PlanePoints& d, const Lanes& at_c,
                                        const Lanes& at_d,
                                        Lanes PlanePoints::*coordinate = nullptr) {
  const Mask cut_c = at_c < 0, cut_d = at_d < 0;
  PlanePoints cut = mix(c, d, at_c / (at_c - at_d));
  if (coordinate) cut.*coordinate = 0;
  c = select(cut_c, cut, c);
  d = select(cut_d, cut, d);
  return cut_c && cut_d;
}

// A linear function n . (x - p) of a point x, and how far rounding may put it off.
struct Side {
  Side() = default;
  Side(const Vec3& normal, float rounding) : n(normal) {
    const Vec3 size = absolute(n);
    tolerance = rounding * (size.x + size.y + size.z);
  }
  Vec3 n{0.0f};
  float tolerance = 0;
};

}  // namespace

// The query's plane and the functions that bound what can hide the segment.
struct SegmentVisibility::Query {
  Query(const Vec3& from, const Vec3& a, const Vec3& along, float max_coordinate,
        std::uint32_t skip)
      : p(from), skipped(skip) {
    const Vec3 to_a = a - p, to_b = to_a + along;
    // Not to_a x to_b: that cancels for a short far segment.
    const Vec3 normal = cross(to_a, along);
    const float inverse = 1 / glm::dot(normal, normal);
    rounding = 0x1p-21f * max_coordinate;
    plane = {normal, rounding};
    alpha = inverse * cross(to_b, normal);
    beta = inverse * cross(normal, to_a);
    depth = {inverse * cross(along, normal), rounding};
    segment = {a - p, along};
  }

  bool degenerate() const { return !(glm::dot(plane.n, plane.n) > 0); }

  // Restricts the search to what hides this part of the segment.
  void narrow(const Interval& hull) {
    after_begin = {(1 - hull.begin) * beta - hull.begin * alpha, rounding};
    before_end = {hull.end * alpha - (1 - hull.end) * beta, rounding};
    hull_begin = segment.first + hull.begin * segment.second;
    hull_end = segment.first + hull.end * segment.second;
    lower = p + glm::min(Vec3(0.0f), glm::min(hull_begin, hull_end));
    upper = p + glm::max(Vec3(0.0f), glm::max(hull_begin, hull_end));
  }

  Vec3 p;
  Side plane;                      // the signed distance e, times |n|
  Vec3 alpha, beta;                // the coordinates alpha and beta
  Side depth;                      // their sum, without the cancellation
  Side after_begin;                // >= 0 for what projects behind the beginning of the hull
  Side before_end;                 // >= 0 for what projects before its end
  std::pair<Vec3, Vec3> segment;   // beginning, from p, and direction
  Vec3 hull_begin, hull_end;       // from p
  Vec3 lower, upper;               // bounds of p and the hull
  float rounding;
  std::uint32_t skipped;
};

SegmentVisibility::SegmentVisibility(std::span<const Vec3> positions,
                                     std::span<const EmbreeScene::Triangle> triangles,
                                     std::span<const std::uint32_t> group,
                                     std::span<const Sphere> spheres, int threads)
    : spheres_(spheres.begin(), spheres.end()) {
  for (const Vec3& v : positions)
    max_coordinate_ = std::max(max_coordinate_, max_component(absolute(v)));
  if (!triangles.empty()) TreeBuilder(*this, positions, triangles, group).build(threads);
}

IntervalSet SegmentVisibility::visible_part(const Vec3& p, const Vec3& a, const Vec3& d,
                                            const Interval& range, std::uint32_t skipped) const {
  IntervalSet visible(range);
  const float coordinate = std::max(max_coordinate_, max_component(absolute(p)));
  Query query(p, a, d, coordinate, skipped);
  if (visible.empty() || query.degenerate()) return visible;
  for (const Sphere& sphere : spheres_) subtract_sphere(sphere, p, a, d, visible);
  if (!nodes_.empty() && !visible.empty()) walk(query, visible);
  return visible;
}

void SegmentVisibility::walk(Query& query, IntervalSet& visible) const {
  query.narrow(visible.hull());
  std::uint32_t stack[kWidth * 64];  // Embree's builder stops at depth 32, then splits evenly
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t item = stack[--size];
    if (item & kLeaf) {
      const Interval before = visible.hull();
      subtract_block(blocks_[item & ~kLeaf], query, visible);
      if (visible.empty()) return;
      const Interval after = visible.hull();
      if (after.begin != before.begin || after.end != before.end) query.narrow(after);
      continue;
    }
    const Node& node = nodes_[item];
    for (unsigned met = children_met(node, query); met != 0; met &= met - 1) {
      const std::uint32_t child = node.children[std::countr_zero(met)];
      prefetch(child);
      stack[size++] = child;
    }
  }
}

// Asks memory for an item that will be visited soon: large trees live outside the caches.
void SegmentVisibility::prefetch(std::uint32_t item) const {
  const char* memory = item & kLeaf ? reinterpret_cast<const char*>(&blocks_[item & ~kLeaf])
                                    : reinterpret_cast<const char*>(&nodes_[item]);
  const std::size_t size = item & kLeaf ? sizeof(Block) : sizeof(Node);
  for (std::size_t line = 0; line < size; line += 64) __builtin_prefetch(memory + line);
}

unsigned SegmentVisibility::children_met(const Node& node, const Query& query) {
  const auto& bounds = node.bounds;
  // The extremes of n . (x - p) over each box are at corners that the signs of n choose.
  const auto extreme = [&](const Vec3& n, bool upper) {
    const int x = (n.x > 0) == upper, y = (n.y > 0) == upper, z = (n.z > 0) == upper;
    return dot(n, load(bounds[x][0]) - query.p.x, load(bounds[y][1]) - query.p.y,
               load(bounds[z][2]) - query.p.z);
  };
  // Exact comparisons: the query's own rounding is far below the offset of its ends from surfaces.
  Mask met = load(bounds[0][0]) <= query.upper.x && load(bounds[1][0]) >= query.lower.x &&
             load(bounds[0][1]) <= query.upper.y && load(bounds[1][1]) >= query.lower.y &&
             load(bounds[0][2]) <= query.upper.z && load(bounds[1][2]) >= query.lower.z;
  met = met && extreme(query.plane.n, true) >= -query.plane.tolerance &&
        extreme(query.plane.n, false) <= query.plane.tolerance;
  met = met && extreme(query.after_begin.n, true) >= -query.after_begin.tolerance &&
        extreme(query.before_end.n, true) >= -query.before_end.tolerance;
  met = met && extreme(query.depth.n, false) <= 1 + query.depth.tolerance;
  return to_bits(met) & ((1u << node.count) - 1);
}

void SegmentVisibility::subtract_block(const Block& block, const Query& query,
                                       IntervalSet& visible) {
  Lanes x[3], y[3], z[3], alpha[3], beta[3], depth[3], e[3];
  for (int corner = 0; corner < 3; ++corner) {
    x[corner] = load(block.corners[corner][0]) - query.p.x;
    y[corner] = load(block.corners[corner][1]) - query.p.y;
    z[corner] = load(block.corners[corner][2]) - query.p.z;
    alpha[corner] = dot(query.alpha, x[corner], y[corner], z[corner]);
    beta[corner] = dot(query.beta, x[corner], y[corner], z[corner]);
    depth[corner] = dot(query.depth.n, x[corner], y[corner], z[corner]);
    e[corner] = dot(query.plane.n, x[corner], y[corner], z[corner]);
  }
  const Corners corners[3] = {{{x[0], y[0], z[0]}, e[0]},
                              {{x[1], y[1], z[1]}, e[1]},
                              {{x[2], y[2], z[2]}, e[2]}};
  const Mask above[3] = {e[0] >= 0, e[1] >= 0, e[2] >= 0};
  const Mask crosses = (above[0] || above[1] || above[2]) && !(above[0] && above[1] && above[2]);
  const Mask inside = (alpha[0] > 0 || alpha[1] > 0 || alpha[2] > 0) &&
                      (beta[0] > 0 || beta[1] > 0 || beta[2] > 0) &&
                      (depth[0] < 1 || depth[1] < 1 || depth[2] < 1);
  Mask may_hide = crosses && inside;
  if (simd::none_of(may_hide)) return;
  may_hide = may_hide && separates(x, y, z, query.hull_begin, query.hull_end);
  if (simd::none_of(may_hide)) return;

  // Two of the three edges cross the plane.
  const auto in_plane = [&query](const Points& q) {
    return PlanePoints{dot(query.alpha, q.x, q.y, q.z), dot(query.beta, q.x, q.y, q.z),
                       dot(query.depth.n, q.x, q.y, q.z)};
  };
  const Points on_12 = crossing(corners[1], corners[2]);
  PlanePoints c =
      in_plane(select(above[0] != above[1], crossing(corners[0], corners[1]), on_12));
  PlanePoints d =
      in_plane(select(above[2] != above[0], crossing(corners[2], corners[0]), on_12));
  Mask gone = !may_hide;
  gone = gone || clip(c, d, c.alpha, d.alpha, &PlanePoints::alpha);
  gone = gone || clip(c, d, c.beta, d.beta, &PlanePoints::beta);
  gone = gone || clip(c, d, 1 - c.depth, 1 - d.depth);
  const Lanes tc = c.t(), td = d.t();
  const Interval hull = visible.hull();
  const Lanes begin = simd::min(tc, td), end = simd::max(tc, td);
  Mask hides = !gone && begin < end && begin < hull.end && end > hull.begin;
  while (simd::any_of(hides)) {
    const int i = simd::find_first_set(hides);
    hides[i] = false;
    if (query.skipped != kNone && block.group[i] == query.skipped) continue;
    visible.subtract(begin[i], end[i]);
    if (visible.empty()) return;
  }
}

}  // namespace raytracing
