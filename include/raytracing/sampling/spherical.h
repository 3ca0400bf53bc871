#pragma once
// Uniform sampling of the solid angle of rectangles and triangles.

#include <array>
#include <optional>

#include "raytracing/geometry/shapes.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// Returns true when lights are sampled uniformly in this solid angle, in steradians. Below the
/// lower limit, sampling uniform in area is nearly uniform in solid angle and cheaper. The upper
/// limit is nearly 2 pi, the solid angle of a plane. Points exceed it at a distance of about 1e-5
/// light diameters, where the rounding of the light's plane leaves the solid angle undetermined.
constexpr bool is_usable_solid_angle(double solid_angle) {
  return solid_angle > 3e-3 && solid_angle < 6.2831;
}

/// A rectangle projected onto the unit sphere around a point (Ureña, Fajardo & King 2013, section
/// 3).
class SphericalRectangle {
 public:
  SphericalRectangle(const Rectangle& rectangle, const Vec3& from);

  /// The solid angle in steradians. Its absolute error is below 1e-9, for the float coordinates of
  /// the rectangle and `from` as they are.
  double solid_angle() const { return solid_angle_; }
  /// Returns a point of the rectangle whose direction is uniform in solid angle.
  Vec3 sample(const Vec2& u) const;

  /// The line x = const of the rectangle on which sample() places its point for a given u.x.
  struct Strip {
    float x;                ///< distance from the corner of the rectangle along its x
    double y_begin;         ///< y of the beginning of the line, relative to the foot of the point
    double line_distance2;  ///< squared distance of the point from the line
  };
  Strip strip(float u) const;

 private:
  // Returns true when float arithmetic is too coarse to sample this rectangle.
  bool needs_double() const;
  template <class Real>
  Real sample_x(float u) const;
  template <class Real>
  Vec3 sample_in(const Vec2& u) const;

  Vec3 from_, x_, y_, z_;
  double x0_, y0_, z0_, x1_, y1_;
  double b0_, b1_, solid_angle_;
  DVec2 k_;  // (cos k, sin k)
};

/// A triangle projected onto the unit sphere around a point (Arvo 1995, section 3), in double
/// precision.
class SphericalTriangle {
 public:
  SphericalTriangle(const std::array<Vec3, 3>& corners, const Vec3& from);

  /// The solid angle in steradians (Van Oosterom & Strackee 1983, eq. 8).
  double solid_angle() const { return solid_angle_; }
  /// Returns a point of the triangle whose direction is uniform in solid angle, or nothing when the
  /// triangle is degenerate or the point lies in its plane.
  std::optional<Vec3> sample(const Vec2& u) const;

 private:
  DVec3 from_, normal_;  // the normal has any length
  double height_;        // distance of the plane, in lengths of the normal
  DVec3 a_, b_, c_;      // unit directions of the corners
  double alpha_, cos_c_, solid_angle_;
};

}  // namespace raytracing
