#pragma once
// Uniform sampling of the solid angle of flat shapes.

#include <array>
#include <optional>

#include "raytracing/math/vec.h"

namespace raytracing {

/// A rectangle in space: corner, unit edge directions (orthogonal) and edge lengths.
struct Rectangle {
  Vec3 corner;
  Vec3 x, y;
  float width;   ///< along x
  float height;  ///< along y
};

/// A rectangle seen from a point (Ureña, Fajardo & King 2013, section 3).
class SphericalRectangle {
 public:
  SphericalRectangle(const Rectangle& rectangle, const Vec3& from);

  /// Steradians, to 1e-9 for the rectangle and `from` as they are in float.
  double solid_angle() const { return solid_angle_; }
  /// A point of the rectangle; its direction is uniform in solid angle.
  Vec3 sample(const Vec2& u) const;

  /// The line x = const on which sample() puts its point for a given u.x.
  struct Strip {
    float x;                ///< from the rectangle's corner along its x
    float pdf_x;            ///< per unit of x
    double y_begin;         ///< of the line's beginning, from the foot of the point along y
    double line_distance2;  ///< from the point to the line, squared
  };
  Strip strip(float u) const;

 private:
  bool needs_double() const;  // whether float arithmetic is too coarse to choose points
  template <class Real>
  Real sample_x(float u) const;
  template <class Real>
  Vec3 sample_in(const Vec2& u) const;

  Vec3 from_, x_, y_, z_;
  double x0_, y0_, z0_, x1_, y1_;
  double b0_, b1_, solid_angle_;
  DVec2 k_;  // (cos k, sin k)
};

/// A triangle seen from a point (Arvo 1995, section 3), in double precision.
class SphericalTriangle {
 public:
  SphericalTriangle(const std::array<Vec3, 3>& corners, const Vec3& from);

  /// Steradians (Van Oosterom & Strackee 1983, eq. 8).
  double solid_angle() const { return solid_angle_; }
  /// A point of the triangle; its direction is uniform in solid angle. Nothing for a degenerate
  /// triangle or one seen from within its plane.
  std::optional<Vec3> sample(const Vec2& u) const;

 private:
  DVec3 from_, normal_;  // of any length
  double height_;        // of the plane, in lengths of the normal
  DVec3 a_, b_, c_;      // unit directions of the corners
  double alpha_, cos_c_, solid_angle_;
};

}  // namespace raytracing
