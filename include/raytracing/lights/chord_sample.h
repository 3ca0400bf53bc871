#pragma once

#include <optional>
#include <span>

#include "raytracing/lights/area_light.h"
#include "raytracing/math/interval_set.h"

namespace raytracing {

/// One random chord of a light, for estimators that integrate along it.
struct WeightedChord {
  Chord chord;
  float pdf_u;  ///< density of the chord per unit of length across the chords
};

/// Chooses a chord by the uniform number u in [0,1). The chords run along the light's longest edge
/// (`direction` = 0) or across it (1). Of a rectangle the density is, within a factor of 2, uniform
/// in the angle that `from` sees across the chords' lines, of other polygons in area; it is
/// continuous over the light, since a jump would cost the convergence an order. Nothing when `from`
/// does not see the emitting side, or where rounding leaves no chord.
std::optional<WeightedChord> sample_whole_chord(const AreaLight& light, const Vec3& from,
                                                int direction, float u);

/// One random chord of a light, and the distribution of light points along it. Over all chords the
/// points are uniform in the solid angle seen from the point for which the chord was chosen, or,
/// for polygons that are no rectangles and very small or large solid angles, uniform in area.
struct ChordSample {
  Chord chord;
  float pdf_u;        ///< density of the chord per unit of length across the chords
  float solid_angle;  ///< of the light where points are uniform in it; 0 where uniform in area

  /// The probability that a point of this chord falls into `part`.
  float share(const Interval& part) const;
  /// The point, as a parameter of the chord, that has the share x in [0,1) of all that `parts`
  /// have together before it. There must be a part.
  float parameter(std::span<const Interval> parts, float x) const;

  // Along the chord the measure is its parameter, or y / sqrt(y^2 + line_distance^2) with y counted
  // from the foot of the point: the inner step of Ureña et al. 2013.
  // Close to the light its inverse loses what float has of digits.
  double begin;           ///< y at the chord's beginning
  double line_distance2;  ///< from the point to the chord's line, squared

 private:
  double measure(float t) const;
};

/// As sample_whole_chord, for estimators that take a point of the chord.
std::optional<ChordSample> sample_chord(const AreaLight& light, const Vec3& from, int direction,
                                        float u);

/// Density per steradian, seen from `from`, of the point `q` of the light under sample_chord and a
/// point chosen by the chord's own measure. It is the same for both directions.
float chord_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q);

}  // namespace raytracing
