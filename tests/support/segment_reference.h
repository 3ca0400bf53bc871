#pragma once
// A reference implementation of segment queries: loops over all triangles in double precision.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "raytracing/geometry/occluder_tree.h"
#include "support/statistics.h"

namespace raytracing {

struct SegmentQuery {
  Vec3 p, a, d;
  DVec3 at(double t) const { return DVec3(a) + t * DVec3(d); }
};

using Pieces = std::vector<std::pair<double, double>>;

struct SegmentScene {
  std::vector<Vec3> positions;
  std::vector<EmbreeScene::Triangle> triangles;
  std::vector<Sphere> spheres;

  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto n = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    triangles.push_back({{n, n + 1, n + 2}});
  }
  OccluderTree build() const {
    const std::vector<std::uint32_t> none(triangles.size(), kNone);
    return {positions, triangles, none, spheres, 1};
  }
  EmbreeScene embree() const { return {positions, triangles, spheres, 1}; }
  std::array<DVec3, 3> corners(std::size_t i) const {
    const auto& c = triangles[i].corners;
    return {DVec3(positions[c[0]]), DVec3(positions[c[1]]), DVec3(positions[c[2]])};
  }
  /// The float spacing of the largest coordinate.
  double spacing(const SegmentQuery& query) const {
    double largest = 0;
    const auto count = [&](const DVec3& x) {
      largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    };
    for (const Vec3& x : positions) count(DVec3(x));
    for (const Sphere& s : spheres) largest = std::max<double>(largest, s.max_coordinate());
    for (const DVec3& x : {DVec3(query.p), query.at(0), query.at(1)}) count(x);
    return 0x1p-24 * largest;
  }
};

/// Returns the part of [0,1] that one triangle occludes, which is empty (begin >= end) for none.
inline std::pair<double, double> hidden_by(const std::array<DVec3, 3>& x, const SegmentQuery& q) {
  const DVec3 p(q.p), to_a = DVec3(q.a) - p, to_b = to_a + DVec3(q.d);
  const DVec3 n = cross(to_a, DVec3(q.d));
  std::vector<DVec3> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const DVec3 &u = x[i], &v = x[(i + 1) % 3];
    const double eu = dot(n, u - p), ev = dot(n, v - p);
    if ((eu >= 0) != (ev >= 0)) ends.push_back(u + (eu / (eu - ev)) * (v - u) - p);
  }
  if (ends.size() != 2) return {1, 0};
  const auto weights = [&](const DVec3& r) {
    return glm::dvec2(dot(cross(to_b, n), r), dot(cross(n, to_a), r)) / dot(n, n);
  };
  const glm::dvec2 c = weights(ends[0]), step = weights(ends[1]) - c;
  double first = 0, last = 1;
  for (const auto& [at_c, change] : {std::pair{c.x, step.x}, std::pair{c.y, step.y},
                                     std::pair{1 - c.x - c.y, -step.x - step.y}}) {
    if (at_c < 0 && at_c + change <= 0) return {1, 0};
    if (change > 0) first = std::max(first, -at_c / change);
    if (change < 0) last = std::min(last, -at_c / change);
    if (change == 0 && at_c < 0) return {1, 0};
  }
  if (!(first < last)) return {1, 0};
  const auto t = [&](double s) { return (c.y + s * step.y) / (c.x + c.y + s * (step.x + step.y)); };
  return std::minmax({t(first), t(last)});
}

inline bool sphere_hides(const Sphere& sphere, const DVec3& p, const DVec3& x) {
  const DVec3 m = p - DVec3(sphere.center), w = x - p;
  const double a = dot(w, w), b = dot(m, w);
  const double c = dot(m, m) - static_cast<double>(sphere.radius) * sphere.radius;
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0)) return false;
  const double root = std::sqrt(discriminant);
  const double near = (-b - root) / a, far = (-b + root) / a;
  return (near > 0 && near < 1) || (far > 0 && far < 1);
}

/// Returns whether one of the occluded intervals `hidden` contains this parameter.
inline bool covered(const Pieces& hidden, double t) {
  return std::any_of(hidden.begin(), hidden.end(),
                     [t](const auto& piece) { return piece.first < t && t < piece.second; });
}

inline Pieces hidden_pieces(const SegmentScene& scene, const SegmentQuery& query) {
  Pieces pieces;
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const auto piece = hidden_by(scene.corners(i), query);
    if (piece.first < piece.second) pieces.push_back(piece);
  }
  return pieces;
}

inline bool hidden_at(const SegmentScene& scene, const Pieces& pieces, const SegmentQuery& query,
                      double t) {
  if (covered(pieces, t)) return true;
  return std::any_of(scene.spheres.begin(), scene.spheres.end(), [&](const Sphere& sphere) {
    return sphere_hides(sphere, DVec3(query.p), query.at(t));
  });
}

inline bool seen_at(const IntervalSet& set, double t) {
  return std::any_of(set.intervals().begin(), set.intervals().end(),
                     [t](const Interval& part) { return part.begin <= t && t <= part.end; });
}

/// Returns the distance of two segments (Ericson 2005, section 5.1.9).
inline double segment_distance(const DVec3& p1, const DVec3& q1, const DVec3& p2, const DVec3& q2) {
  const DVec3 d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
  const double a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r), c = dot(d1, r), b = dot(d1, d2);
  if (e == 0) return length(r - std::clamp(a > 0 ? c / -a : 0.0, 0.0, 1.0) * -d1);
  const double denominator = a * e - b * b;
  double s = denominator > 0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double t = (b * s + f) / e;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((b * t - c) / a, 0.0, 1.0);
  }
  return length(p1 + s * d1 - p2 - t * d2);
}

/// Returns how far the visibility at t is from changing: the distance of the ray to the nearest
/// edge or silhouette, or of one of its ends to the plane of the nearest surface.
inline double clearance(const SegmentScene& scene, const SegmentQuery& query, double t) {
  const DVec3 p(query.p), x = query.at(t);
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const auto c = scene.corners(i);
    for (std::size_t k = 0; k < 3; ++k)
      best = std::min(best, segment_distance(p, x, c[k], c[(k + 1) % 3]));
    const DVec3 n = cross(c[1] - c[0], c[2] - c[0]);
    if (!(dot(n, n) > 0)) continue;
    best = std::min(best, std::abs(dot(normalize(n), x - c[0])));
    best = std::min(best, std::abs(dot(normalize(n), p - c[0])));
  }
  for (const Sphere& sphere : scene.spheres) {
    const DVec3 m(sphere.center);
    for (double distance : {length(p - m), length(x - m), segment_distance(p, x, m, m)})
      best = std::min(best, std::abs(distance - sphere.radius));
  }
  return best;
}

/// Returns the largest clearance, in float spacings of the largest coordinate, of a point of [0,1]
/// on which `set` and the loops disagree, or 0 when they agree.
inline double worst_error(const SegmentScene& scene, const SegmentQuery& query,
                          const IntervalSet& set, int extra_points = 0) {
  const Pieces pieces = hidden_pieces(scene, query);
  std::vector<double> ends{0, 1};
  for (const auto& [begin, end] : pieces) ends.insert(ends.end(), {begin, end});
  for (const Interval& part : set.intervals()) ends.insert(ends.end(), {part.begin, part.end});
  for (int i = 1; i < extra_points; ++i) ends.push_back(static_cast<double>(i) / extra_points);
  std::sort(ends.begin(), ends.end());
  double worst = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double t = 0.5 * (ends[i] + ends[i + 1]);
    if (ends[i + 1] - ends[i] < 1e-12 || t <= 0 || t >= 1) continue;  // rounding of the loops
    if (seen_at(set, t) == hidden_at(scene, pieces, query, t))
      worst = std::max(worst, clearance(scene, query, t));
  }
  return worst / scene.spacing(query);
}

/// Adds a sphere of triangles with shared corners: an octahedron with faces split in four `levels`
/// times.
inline void add_tessellated_sphere(SegmentScene& scene, const Sphere& sphere, int levels,
                                   const std::array<Vec3, 3>& axes) {
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Vec3> unit{axes[0], axes[1], axes[2], -axes[0], -axes[1], -axes[2]};
  std::vector<Triangle> faces{{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                              {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, fresh] = middles.try_emplace(std::minmax(a, b), unit.size());
      if (fresh) unit.push_back(normalize(unit[a] + unit[b]));
      return place->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : faces) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = std::move(finer);
  }
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  for (const Vec3& v : unit) scene.positions.push_back(sphere.center + sphere.radius * v);
  for (const auto& [a, b, c] : faces)
    scene.triangles.push_back({{first + a, first + b, first + c}});
}

}  // namespace raytracing
