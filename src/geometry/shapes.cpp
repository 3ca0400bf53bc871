#include "raytracing/geometry/shapes.h"

#include <array>

namespace raytracing {
namespace {

// The sorted parameters in [0,1] at which the shadow of a sphere on a segment may begin or end: the
// two ends, and up to four between them.
struct Candidates {
  std::array<float, 6> values{0, 1};
  std::size_t size = 2;

  void add(double t) {
    if (!(t > 0 && t < 1)) return;
    std::size_t i = size++;
    for (; values[i - 1] > t; --i) values[i] = values[i - 1];
    values[i] = static_cast<float>(t);
  }
};

// Adds the roots of q2 t^2 + 2 q1 t + q0.
void add_roots(double q2, double q1, double q0, Candidates& candidates) {
  const double discriminant = q1 * q1 - q2 * q0;
  if (!(discriminant >= 0)) return;
  const double q = -(q1 + std::copysign(std::sqrt(discriminant), q1));
  if (q2 != 0) candidates.add(q / q2);
  if (q != 0) candidates.add(q0 / q);
}

bool occludes(const Sphere& sphere, const Vec3& p, const Vec3& q) {
  const auto crossings = intersect_line(sphere, {p, q - p});
  if (!crossings) return false;
  const auto [near, far] = *crossings;
  return (near > 0 && near < 1) || (far > 0 && far < 1);
}

}  // namespace

void subtract_shadow(const Sphere& sphere, const Vec3& p, const Vec3& a, const Vec3& d,
                     IntervalSet& visible) {
  // With m = p - centre and the direction w(t) = a - p + t d, the line from p is tangent to the
  // sphere where (m.w)^2 = w.w (m.m - r^2); the segment itself enters or leaves it where
  // |m + w|^2 = r^2.
  const DVec3 m = DVec3(p) - DVec3(sphere.center);
  const DVec3 w = DVec3(a) - DVec3(p), along = DVec3(d);
  const double r2 = static_cast<double>(sphere.radius) * sphere.radius;
  const double outside = dot(m, m) - r2;
  const double mw = dot(m, w), md = dot(m, along);
  Candidates candidates;
  add_roots(md * md - dot(along, along) * outside, mw * md - dot(w, along) * outside,
            mw * mw - dot(w, w) * outside, candidates);
  const DVec3 c = m + w;
  add_roots(dot(along, along), dot(c, along), dot(c, c) - r2, candidates);
  const auto& t = candidates.values;
  for (std::size_t i = 0; i + 1 < candidates.size; ++i) {
    const float middle = 0.5f * (t[i] + t[i + 1]);
    if (occludes(sphere, p, a + middle * d)) visible.subtract(t[i], t[i + 1]);
  }
}

}  // namespace raytracing
