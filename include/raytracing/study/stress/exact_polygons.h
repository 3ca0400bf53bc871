#pragma once
// Direct light from polygons in closed form, in long double, against which the estimators are
// tested. All polygons here are planar and convex.

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "raytracing/math/vec.h"

namespace raytracing {

using LVec3 = glm::vec<3, long double>;
using LPolygon = std::vector<LVec3>;

inline LPolygon long_polygon(std::span<const Vec3> corners) {
  LPolygon polygon;
  for (const Vec3& corner : corners) polygon.emplace_back(corner);
  return polygon;
}

/// The part of a polygon where dot(x - p, n) >= 0 (Sutherland & Hodgman 1974).
inline LPolygon clip(const LPolygon& polygon, const LVec3& p, const LVec3& n) {
  LPolygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const LVec3& a = polygon[i];
    const LVec3& b = polygon[(i + 1) % polygon.size()];
    const long double da = dot(a - p, n), db = dot(b - p, n);
    if (da >= 0) kept.push_back(a);
    if ((da < 0) != (db < 0)) kept.push_back(a + (da / (da - db)) * (b - a));
  }
  return kept;
}

/// Twice the area, along the normal.
inline LVec3 area_vector(const LPolygon& polygon) {
  LVec3 sum(0.0L);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return sum;
}

/// The inward normal, in the polygon's plane, of the edge that starts at corner i; not unit.
inline LVec3 inward(const LPolygon& polygon, std::size_t i) {
  return cross(area_vector(polygon), polygon[(i + 1) % polygon.size()] - polygon[i]);
}

/// The common part of two polygons of one plane.
inline LPolygon intersection(LPolygon polygon, const LPolygon& window) {
  for (std::size_t i = 0; i < window.size(); ++i)
    polygon = clip(polygon, window[i], inward(window, i));
  return polygon;
}

/// The polygons without the window, all of one plane, in convex pieces.
std::vector<LPolygon> difference(const std::vector<LPolygon>& polygons, const LPolygon& window);

/// The part of `light` that is visible from p behind the occluders, in convex pieces.
std::vector<LPolygon> visible_pieces(const LPolygon& light, std::span<const LPolygon> occluders,
                                     const LVec3& p);

/// The shadow of `polygon` on the plane of `screen`, with the light at `from`. The polygon must lie
/// between the two.
inline LPolygon shadow(const LPolygon& polygon, const LVec3& from, const LPolygon& screen) {
  const LVec3 n = area_vector(screen);
  LPolygon projected;
  for (const LVec3& corner : polygon) {
    const LVec3 d = corner - from;
    projected.push_back(from + (dot(screen[0] - from, n) / dot(d, n)) * d);
  }
  return projected;
}

/// Irradiance at p, with the unit normal n, from a convex polygon that emits radiance 1
/// on both sides (Lambert 1760): half the sum of the edges' angles times the cosines of their
/// planes.
inline long double lambert(const LPolygon& polygon, const LVec3& p, const LVec3& n) {
  const LPolygon above = clip(polygon, p, n);
  long double sum = 0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    const LVec3 a = above[i] - p, b = above[(i + 1) % above.size()] - p;
    const LVec3 c = cross(a, b);
    const long double l = length(c);
    if (l > 0) sum += std::atan2(l, dot(a, b)) * dot(c, n) / l;
  }
  return std::abs(sum) / 2;
}

}  // namespace raytracing
