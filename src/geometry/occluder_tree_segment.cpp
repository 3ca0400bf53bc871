// OccluderTree::visible_part: the exact visible part of a segment.

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "float8.h"
#include "raytracing/geometry/occluder_tree.h"

namespace raytracing {
namespace {

using raytracing::select;

// Returns n . x for eight points.
Float8 dot(const Vec3& n, const Float8& x, const Float8& y, const Float8& z) {
  return n.x * x + (n.y * y + n.z * z);
}

// Eight points of the plane of a query, by the coordinates alpha and beta. Their sum, the depth, is
// 0 at p and 1 on the segment. It is stored separately, because alpha and beta are large and would
// cancel for a short, far segment.
struct PlanePoints {
  Float8 alpha, beta, depth;
  Float8 t() const { return beta / (alpha + beta); }  // exactly 0 or 1 after clip()
};

[[gnu::always_inline]] inline PlanePoints select(const Mask8& mask, const PlanePoints& yes,
                                                 const PlanePoints& no) {
  return {select(mask, yes.alpha, no.alpha), select(mask, yes.beta, no.beta),
          select(mask, yes.depth, no.depth)};
}

[[gnu::always_inline]] inline PlanePoints mix(const PlanePoints& a, const PlanePoints& b,
                                              const Float8& s) {
  return {a.alpha + s * (b.alpha - a.alpha), a.beta + s * (b.beta - a.beta),
          a.depth + s * (b.depth - a.depth)};
}

// The same corner of eight triangles.
struct Corners {
  Points at;  // relative to p
  Float8 e;   // signed distance from the plane of the query, scaled by the length of its normal
};

// Returns the points where the edges between a and b intersect the plane. Each is interpolated from
// the corner that is nearer to the plane or, of two equally near, from the one with e >= 0: the two
// triangles that share an edge get the same point, and no light leaks between them. The
// interpolation is done in space, because alpha and beta of corners far from a near segment are
// large, and their rounding would be that of t.
[[gnu::always_inline]] inline Points crossing(const Corners& a, const Corners& b) {
  const Mask8 a_first = (a.e >= 0) == (a.e + b.e <= 0);  // the signs of the two differ
  const Points first = select(a_first, a.at, b.at), second = select(a_first, b.at, a.at);
  const Float8 e_first = select(a_first, a.e, b.e), e_second = select(a_first, b.e, a.e);
  const Float8 s = e_first / (e_first - e_second);
  return {first.x + s * (second.x - first.x), first.y + s * (second.y - first.y),
          first.z + s * (second.z - first.z)};
}

// Returns which of the planes of eight triangles, with corners relative to p, separate p from some
// point of the segment from a to b. The others occlude nothing. Without this test the receiver's
// own face, which lies a few roundings behind p, would occlude a far light, for which alpha and
// beta are known only up to such roundings.
Mask8 separates(const Float8 (&x)[3], const Float8 (&y)[3], const Float8 (&z)[3], const Vec3& a,
                const Vec3& b) {
  const Float8 ux = x[1] - x[0], uy = y[1] - y[0], uz = z[1] - z[0];
  const Float8 vx = x[2] - x[0], vy = y[2] - y[0], vz = z[2] - z[0];
  const Float8 nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  const auto side = [&](const Vec3& q) {
    return nx * (q.x - x[0]) + (ny * (q.y - y[0]) + nz * (q.z - z[0]));
  };
  const Float8 of_p = side(Vec3(0.0f)), of_a = side(a), of_b = side(b);
  return !((of_p > 0 && of_a > 0 && of_b > 0) || (of_p < 0 && of_a < 0 && of_b < 0));
}

// Clips the segments from c to d to where a linear function is not negative. `at_c` and `at_d` are
// its values at the ends. When the function is a coordinate, `coordinate` names it, and it becomes
// exactly 0 at the new end. Returns which segments vanish.
[[gnu::always_inline]] inline Mask8 clip(PlanePoints& c, PlanePoints& d, const Float8& at_c,
                                         const Float8& at_d,
                                         Float8 PlanePoints::*coordinate = nullptr) {
  const Mask8 cut_c = at_c < 0, cut_d = at_d < 0;
  PlanePoints cut = mix(c, d, at_c / (at_c - at_d));
  if (coordinate) cut.*coordinate = 0;
  c = select(cut_c, cut, c);
  d = select(cut_d, cut, d);
  return cut_c && cut_d;
}

// A linear function n . (x - p) of a point x with a bound of its rounding error.
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

// The plane of a query and the linear functions that bound the possible occluders.
struct OccluderTree::SegmentQuery {
  SegmentQuery(const Vec3& from, const Vec3& a, const Vec3& along, float max_coordinate,
               std::uint32_t skip)
      : p(from), skipped(skip) {
    const Vec3 to_a = a - p, to_b = to_a + along;
    // The normal is not computed as to_a x to_b, which cancels for a short, far segment.
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

  // Restricts the traversal to what may occlude this part of the segment.
  void narrow(const Interval& hull) {
    after_begin = {(1 - hull.begin) * beta - hull.begin * alpha, rounding};
    before_end = {hull.end * alpha - (1 - hull.end) * beta, rounding};
    hull_begin = segment.first + hull.begin * segment.second;
    hull_end = segment.first + hull.end * segment.second;
    lower = p + glm::min(Vec3(0.0f), glm::min(hull_begin, hull_end));
    upper = p + glm::max(Vec3(0.0f), glm::max(hull_begin, hull_end));
  }

  Vec3 p;
  Side plane;                     // signed distance e from the plane, scaled by |n|
  Vec3 alpha, beta;               // gradients of the coordinates alpha and beta
  Side depth;                     // alpha + beta without cancellation
  Side after_begin;               // >= 0 for points that project behind the beginning of the hull
  Side before_end;                // >= 0 for points that project before the end of the hull
  std::pair<Vec3, Vec3> segment;  // beginning, relative to p, and direction
  Vec3 hull_begin, hull_end;      // ends of the part that is still visible, relative to p
  Vec3 lower, upper;              // bounds of p and of that part
  float rounding;
  std::uint32_t skipped;
};

IntervalSet OccluderTree::visible_part(const Vec3& p, const Vec3& a, const Vec3& d,
                                       const Interval& range, std::uint32_t skipped) const {
  if (!built_) throw std::logic_error("a visible part was asked for without an occluder tree");
  IntervalSet visible(range);
  const float coordinate = std::max(max_coordinate_, max_component(absolute(p)));
  SegmentQuery query(p, a, d, coordinate, skipped);
  if (visible.empty() || query.degenerate()) return visible;
  for (const Sphere& sphere : spheres_) subtract_shadow(sphere, p, a, d, visible);
  if (!nodes_.empty() && !visible.empty()) traverse(query, visible);
  return visible;
}

void OccluderTree::traverse(SegmentQuery& query, IntervalSet& visible) const {
  query.narrow(visible.hull());
  std::uint32_t stack[kStackSize];
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t item = stack[--size];
    if (item & kLeaf) {
      const Interval before = visible.hull();
      subtract_shadows(blocks_[item & ~kLeaf], query, visible);
      if (visible.empty()) return;
      const Interval after = visible.hull();
      if (after.begin != before.begin || after.end != before.end) query.narrow(after);
      continue;
    }
    const Node& node = nodes_[item];
    for (unsigned met = intersected_children(node, query); met != 0; met &= met - 1) {
      const std::uint32_t child = node.children[std::countr_zero(met)];
      prefetch(child);
      stack[size++] = child;
    }
  }
}

// Prefetches an item that will be visited soon, because large trees do not fit into the caches.
void OccluderTree::prefetch(std::uint32_t item) const {
  const char* memory = item & kLeaf ? reinterpret_cast<const char*>(&blocks_[item & ~kLeaf])
                                    : reinterpret_cast<const char*>(&nodes_[item]);
  const std::size_t size = item & kLeaf ? sizeof(Block) : sizeof(Node);
  for (std::size_t line = 0; line < size; line += 64) __builtin_prefetch(memory + line);
}

unsigned OccluderTree::intersected_children(const Node& node, const SegmentQuery& query) {
  const auto& bounds = node.bounds;
  // The extremes of n . (x - p) over each box are taken at corners given by the signs of n.
  const auto extreme = [&](const Vec3& n, bool upper) {
    const int x = (n.x > 0) == upper, y = (n.y > 0) == upper, z = (n.z > 0) == upper;
    return dot(n, load(bounds[x][0]) - query.p.x, load(bounds[y][1]) - query.p.y,
               load(bounds[z][2]) - query.p.z);
  };
  // The bounds need no tolerance: their rounding is far below the offset of the ends from surfaces.
  Mask8 met = load(bounds[0][0]) <= query.upper.x && load(bounds[1][0]) >= query.lower.x &&
              load(bounds[0][1]) <= query.upper.y && load(bounds[1][1]) >= query.lower.y &&
              load(bounds[0][2]) <= query.upper.z && load(bounds[1][2]) >= query.lower.z;
  met = met && extreme(query.plane.n, true) >= -query.plane.tolerance &&
        extreme(query.plane.n, false) <= query.plane.tolerance;
  met = met && extreme(query.after_begin.n, true) >= -query.after_begin.tolerance &&
        extreme(query.before_end.n, true) >= -query.before_end.tolerance;
  met = met && extreme(query.depth.n, false) <= 1 + query.depth.tolerance;
  return to_bits(met) & ((1u << node.count) - 1);
}

void OccluderTree::subtract_shadows(const Block& block, const SegmentQuery& query,
                                    IntervalSet& visible) {
  Float8 x[3], y[3], z[3], alpha[3], beta[3], depth[3], e[3];
  for (int corner = 0; corner < 3; ++corner) {
    x[corner] = load(block.corners[corner][0]) - query.p.x;
    y[corner] = load(block.corners[corner][1]) - query.p.y;
    z[corner] = load(block.corners[corner][2]) - query.p.z;
    alpha[corner] = dot(query.alpha, x[corner], y[corner], z[corner]);
    beta[corner] = dot(query.beta, x[corner], y[corner], z[corner]);
    depth[corner] = dot(query.depth.n, x[corner], y[corner], z[corner]);
    e[corner] = dot(query.plane.n, x[corner], y[corner], z[corner]);
  }
  const Corners corners[3] = {
      {{x[0], y[0], z[0]}, e[0]}, {{x[1], y[1], z[1]}, e[1]}, {{x[2], y[2], z[2]}, e[2]}};
  const Mask8 above[3] = {e[0] >= 0, e[1] >= 0, e[2] >= 0};
  const Mask8 crosses = (above[0] || above[1] || above[2]) && !(above[0] && above[1] && above[2]);
  const Mask8 inside = (alpha[0] > 0 || alpha[1] > 0 || alpha[2] > 0) &&
                       (beta[0] > 0 || beta[1] > 0 || beta[2] > 0) &&
                       (depth[0] < 1 || depth[1] < 1 || depth[2] < 1);
  Mask8 candidates = crosses && inside;
  if (simd::none_of(candidates)) return;
  candidates = candidates && separates(x, y, z, query.hull_begin, query.hull_end);
  if (simd::none_of(candidates)) return;

  // Two of the three edges of each candidate intersect the plane, at c and d.
  const auto in_plane = [&query](const Points& q) {
    return PlanePoints{dot(query.alpha, q.x, q.y, q.z), dot(query.beta, q.x, q.y, q.z),
                       dot(query.depth.n, q.x, q.y, q.z)};
  };
  const Points on_12 = crossing(corners[1], corners[2]);
  PlanePoints c = in_plane(select(above[0] != above[1], crossing(corners[0], corners[1]), on_12));
  PlanePoints d = in_plane(select(above[2] != above[0], crossing(corners[2], corners[0]), on_12));
  Mask8 gone = !candidates;
  gone = gone || clip(c, d, c.alpha, d.alpha, &PlanePoints::alpha);
  gone = gone || clip(c, d, c.beta, d.beta, &PlanePoints::beta);
  gone = gone || clip(c, d, 1 - c.depth, 1 - d.depth);
  const Float8 tc = c.t(), td = d.t();
  const Interval hull = visible.hull();
  const Float8 begin = simd::min(tc, td), end = simd::max(tc, td);
  Mask8 occludes = !gone && begin < end && begin < hull.end && end > hull.begin;
  while (simd::any_of(occludes)) {
    const int i = simd::find_first_set(occludes);
    occludes[i] = false;
    if (query.skipped != kNone && block.group[i] == query.skipped) continue;
    visible.subtract(begin[i], end[i]);
    if (visible.empty()) return;
  }
}

}  // namespace raytracing
