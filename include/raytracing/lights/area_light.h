#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "raytracing/lights/chords.h"
#include "raytracing/math/vec.h"
#include "raytracing/sampling/discrete.h"
#include "raytracing/sampling/spherical.h"

namespace raytracing {

/// The points corner + s x + t y, with s and t in [0,1].
struct Parallelogram {
  Vec3 corner, x, y;
};

/// A planar convex polygon with 3 or more corners that emits the radiance Le, the same in all
/// directions, on the side of its normal. Counter-clockwise corners as seen from that side.
struct AreaLight {
  /// `corners` must be planar, convex and of positive area.
  AreaLight(std::span<const Vec3> corners, const Rgb& Le);

  std::vector<Vec3> corners;
  Rgb Le;
  Vec3 normal;  ///< unit
  float area;
  float error;                                 ///< position_error of its plane
  std::optional<Parallelogram> parallelogram;  ///< set when it is one
  std::optional<Rectangle> rectangle;          ///< set when all its angles are right
  DiscreteDistribution fan;  ///< by area, of the triangles (0, i+1, i+2) that make the polygon
  std::array<ChordSet, 2> chords;  ///< along the longest edge, and across it

  /// Whether `from` lies on the emitting side of the light's plane.
  bool faces(const Vec3& from) const;

  /// Emitted power of one channel per unit radiance is pi * area; this is pi * area * mean(Le).
  float power() const;
};

/// A point uniform in area, of a light that is no parallelogram.
Vec3 sample_fan(const AreaLight& light, const Vec2& u);

/// A point uniform in area; density 1 / light.area per unit area.
inline Vec3 sample_area(const AreaLight& light, const Vec2& u) {
  if (!light.parallelogram) return sample_fan(light, u);
  const Parallelogram& p = *light.parallelogram;
  return p.corner + u.x * p.x + u.y * p.y;
}

/// Density per steradian, seen from `from`, of a point `q` on the light chosen uniformly in area;
/// infinite or 0 in the light's own plane or behind it.
inline float area_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q) {
  const Vec3 d = q - from;
  const float distance2 = dot(d, d);
  const float height = -dot(d, light.normal);  // distance * cosine at the light
  if (height <= 0) return 0;
  return distance2 * std::sqrt(distance2) / (height * light.area);
}

/// A point of the light whose direction from `from` is uniform in solid angle.
struct SolidAngleSample {
  Vec3 point;
  float pdf_w;           ///< per steradian
  bool by_area = false;  ///< uniform in area instead
};
/// Rectangles by SphericalRectangle, other polygons by the spherical triangles of their fan. Where
/// the solid angle is too small or too large for float arithmetic, samples by area instead
/// (`by_area`). Nothing when `from` does not see the emitting side.
std::optional<SolidAngleSample> sample_solid_angle(const AreaLight& light, const Vec3& from,
                                                   const Vec2& u);
/// The density with which sample_solid_angle chooses the point `q` of the light.
float solid_angle_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q);

}  // namespace raytracing
