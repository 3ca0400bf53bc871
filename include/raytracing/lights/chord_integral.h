#pragma once

#include "raytracing/lights/chord.h"
#include "raytracing/math/interval_set.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// A chord of a light as seen from a point, with the terms that all integrals over its parts share.
/// A part is given by parameters of the chord in [0,1], which avoids rounded end points.
class SeenChord {
 public:
  /// `light_normal` is the unit normal of the light.
  SeenChord(const Chord& chord, const Vec3& from, const Vec3& light_normal);

  /// Returns the part of `whole` above the horizon of the normal n: where n . (x - from) >= 0.
  Interval above_horizon(const Vec3& n, const Interval& whole) const;

  /// Returns the integral over the length of the part of (n . w) (light_normal . -w) / r^2, where w
  /// is the direction from the point and r the distance. This is the irradiance per unit width of
  /// the light at unit radiance, the integral of Billen & Dutré 2016. `part` must lie above the
  /// horizon of n. The result is exact up to rounding, with a relative error of 1e-5 in the worst
  /// known cases: unlike the difference of two antiderivatives, this form does not cancel for a
  /// point near the line of the chord.
  float irradiance(const Vec3& n, const Interval& part) const;

 private:
  float position(float t) const { return begin_ + t * length_; }

  Vec3 direction_;
  Vec3 foot_;  // the nearest point of the line of the chord, relative to the point
  float foot_distance2_;
  float begin_, length_;  // beginning of the chord relative to the foot, and its length
  float height_;          // height of the point above the plane of the light
};

}  // namespace raytracing
