#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "raytracing/geometry/shapes.h"
#include "raytracing/lights/chord.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// The points corner + s x + t y, with s and t in [0,1].
struct Parallelogram {
  Vec3 corner, x, y;
};

/// A planar convex polygon with 3 or more corners, counter-clockwise as seen from the side of its
/// normal. It emits the radiance Le on that side, constant over the polygon and all directions.
struct AreaLight {
  /// `corners` must be planar, convex and of positive area.
  AreaLight(std::span<const Vec3> corners, const Rgb& Le);

  std::vector<Vec3> corners;
  Rgb Le;
  Vec3 normal;  ///< unit
  float area;
  float error;                                 ///< position_error of its plane
  std::optional<Parallelogram> parallelogram;  ///< set when it is one, up to rounding
  std::optional<Rectangle> rectangle;          ///< set when it is a rectangle
  std::array<ChordSet, 2> chords;  ///< parallel to the longest edge, and perpendicular to it

  /// Returns true when `from` lies on the emitting side of the plane.
  bool faces(const Vec3& from) const;

  /// Returns pi * area * mean(Le), the emitted power averaged over the channels.
  float power() const;
};

/// Samples a point uniformly in area, of a light that is no parallelogram.
Vec3 sample_fan(const AreaLight& light, const Vec2& u);

/// Samples a point uniformly in area. Its density is 1 / light.area per unit area.
inline Vec3 sample_area(const AreaLight& light, const Vec2& u) {
  if (!light.parallelogram) return sample_fan(light, u);
  const Parallelogram& p = *light.parallelogram;
  return p.corner + u.x * p.x + u.y * p.y;
}

/// Returns the density, per steradian seen from `from`, of the point `q` when it is sampled
/// uniformly in area. The density is infinite or 0 when `from` lies in the plane of the light, and
/// 0 behind it.
inline float area_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q) {
  const Vec3 d = q - from;
  const float distance2 = dot(d, d);
  const float height = -dot(d, light.normal);  // distance times the cosine at the light
  if (height <= 0) return 0;
  return distance2 * std::sqrt(distance2) / (height * light.area);
}

/// A point of a light whose direction is uniform in the solid angle of the light.
struct SolidAngleSample {
  Vec3 point;
  float pdf_w;           ///< density per steradian
  bool by_area = false;  ///< true when the point is uniform in area instead
};
/// Samples a rectangle as a SphericalRectangle and any other polygon as a fan of
/// SphericalTriangles. Samples uniformly in area instead where the solid angle is not usable
/// (is_usable_solid_angle). Returns nothing when `from` does not see the emitting side.
std::optional<SolidAngleSample> sample_solid_angle(const AreaLight& light, const Vec3& from,
                                                   const Vec2& u);
/// Returns the density, per steradian, with which sample_solid_angle samples the point `q`.
float solid_angle_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q);

}  // namespace raytracing
