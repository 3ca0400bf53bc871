#pragma once
// Reference geometry in double precision: solid angles in closed form, and a grid of cells that
// cuts a planar convex polygon, with the exact area and solid angle of each piece.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "raytracing/math/vec.h"
#include "support/statistics.h"

namespace raytracing {

using LVec3 = glm::vec<3, long double>;

/// Solid angle of a triangle seen from the origin (Van Oosterom & Strackee 1983, eq. 8).
inline double reference_solid_angle(const LVec3& a, const LVec3& b, const LVec3& c) {
  const long double la = length(a), lb = length(b), lc = length(c);
  const long double volume = std::abs(dot(a, cross(b - a, c - a)));
  const long double denominator = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return static_cast<double>(2 * std::atan2(volume, denominator));
}

/// Solid angle of a convex planar polygon seen from `from`.
template <class V>
double reference_solid_angle(std::span<const V> corners, const V& from) {
  double sum = 0;
  const auto seen = [&](std::size_t i) { return LVec3(corners[i]) - LVec3(from); };
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += reference_solid_angle(seen(0), seen(i), seen(i + 1));
  return sum;
}

/// A grid over the bounding rectangle of a polygon in its plane.
class PolygonCells {
 public:
  PolygonCells(std::span<const Vec3> corners, std::size_t n) : n_(n), origin_(corners[0]) {
    x_ = normalize(DVec3(corners[1]) - origin_);
    DVec3 normal(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      normal += cross(DVec3(corners[i]) - origin_, DVec3(corners[i + 1]) - origin_);
    y_ = cross(normalize(normal), x_);
    for (const Vec3& c : corners) {
      polygon_.push_back(plane(DVec3(c)));
      low_ = glm::min(low_, polygon_.back());
      high_ = glm::max(high_, polygon_.back());
    }
  }

  std::size_t size() const { return n_ * n_; }
  std::size_t cell(const Vec3& p) const {
    const glm::dvec2 q = (plane(DVec3(p)) - low_) / (high_ - low_);
    return n_ * cell_of(q.x, n_) + cell_of(q.y, n_);
  }
  /// Distance of `p` from the polygon's plane and, in the plane, outside its edges.
  double distance_outside(const Vec3& p) const {
    const DVec3 d = DVec3(p) - origin_;
    const glm::dvec2 q = plane(DVec3(p));
    double worst = std::abs(dot(d, cross(x_, y_)));
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const glm::dvec2 a = polygon_[i], e = polygon_[(i + 1) % polygon_.size()] - a;
      worst = std::max(worst, ((q.x - a.x) * e.y - (q.y - a.y) * e.x) / glm::length(e));
    }
    return worst;
  }
  std::vector<double> areas() const {
    return each([](const std::vector<DVec3>& c) {
      DVec3 twice(0.0);
      for (std::size_t i = 1; i + 1 < c.size(); ++i) twice += cross(c[i] - c[0], c[i + 1] - c[0]);
      return length(twice) / 2;
    });
  }
  std::vector<double> solid_angles(const Vec3& from) const {
    return each(
        [&](const std::vector<DVec3>& c) { return reference_solid_angle<DVec3>(c, DVec3(from)); });
  }

 private:
  glm::dvec2 plane(const DVec3& p) const { return {dot(p - origin_, x_), dot(p - origin_, y_)}; }

  // Keeps the part of a polygon where sign * (coordinate - bound) >= 0 (Sutherland & Hodgman 1974).
  static std::vector<glm::dvec2> cut(const std::vector<glm::dvec2>& polygon, int axis, double bound,
                                     double sign) {
    std::vector<glm::dvec2> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      const double da = sign * (a[axis] - bound), db = sign * (b[axis] - bound);
      if (da >= 0) result.push_back(a);
      if ((da < 0) != (db < 0)) result.push_back(a + (b - a) * (da / (da - db)));
    }
    return result;
  }

  template <class F>
  std::vector<double> each(const F& measure) const {
    std::vector<double> result;
    const glm::dvec2 step = (high_ - low_) / static_cast<double>(n_);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j) {
        const glm::dvec2 a = low_ + step * glm::dvec2(i, j), b = a + step;
        const auto column = cut(cut(polygon_, 0, a.x, 1), 0, b.x, -1);
        const auto piece = cut(cut(column, 1, a.y, 1), 1, b.y, -1);
        std::vector<DVec3> corners;
        for (const glm::dvec2& p : piece) corners.push_back(origin_ + p.x * x_ + p.y * y_);
        result.push_back(corners.size() < 3 ? 0.0 : measure(corners));
      }
    return result;
  }

  std::size_t n_;
  DVec3 origin_, x_, y_;
  std::vector<glm::dvec2> polygon_;
  glm::dvec2 low_{0.0}, high_{0.0};
};

}  // namespace raytracing
