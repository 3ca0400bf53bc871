#pragma once

#include "raytracing/lights/chords.h"
#include "raytracing/math/interval_set.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// A chord of a light as seen from a point: what all integrals over parts of it share. Parts are
/// given by parameters of the chord in [0,1], so that no rounded end points come between.
class SeenChord {
 public:
  /// `light_normal` is the unit normal of the chord's light.
  SeenChord(const Chord& chord, const Vec3& from, const Vec3& light_normal);

  /// The part of `whole` where n . (x - from) >= 0: above the horizon of the normal n.
  Interval above_horizon(const Vec3& n, const Interval& whole) const;

  /// Integral over the part, by length, of (n . w) (light_normal . -w) / r^2, with w the direction
  /// from the point and r the distance: the irradiance of a unit of width of the light at unit
  /// radiance. `part` must lie above the horizon of n. Exact up to rounding, a relative 1e-5 in the
  /// worst cases known: the form keeps its digits where the textbook's difference of two
  /// antiderivatives has none, with the point near the chord's line (the integral of Billen & Dutré
  /// 2016).
  float irradiance(const Vec3& n, const Interval& part) const;

 private:
  float position(float t) const { return begin_ + t * length_; }

  Vec3 direction_;
  Vec3 foot_;  // from the point to the nearest point of the chord's line
  float foot_distance2_;
  float begin_, length_;  // of the chord along its line, from the foot
  float height_;          // of the point above the light's plane
};

}  // namespace raytracing
