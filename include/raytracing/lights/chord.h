#pragma once
// The chords of an area light, and the sampling of chords and of points along them.

#include <optional>
#include <span>
#include <vector>

#include "raytracing/math/interval_set.h"
#include "raytracing/math/vec.h"

namespace raytracing {

struct AreaLight;

/// The intersection of an area light with a line in its plane.
struct Chord {
  Vec3 begin;
  Vec3 direction;  ///< unit
  float length;

  Vec3 at(float t) const { return begin + (t * length) * direction; }  ///< t in [0,1]
};

/// The parallel chords of a planar convex polygon. The coordinate u measures the distance across
/// the chords, in the plane of the polygon, from 0 to extent().
class ChordSet {
 public:
  ChordSet() = default;
  /// `normal` is the unit normal of the polygon; the unit vector `direction` lies in its plane.
  ChordSet(std::span<const Vec3> corners, const Vec3& normal, const Vec3& direction);

  float extent() const { return extent_; }
  /// Returns the chord at u in [0, extent()], or nothing where rounding makes the line miss the
  /// polygon.
  std::optional<Chord> at(float u) const;
  /// Returns the u below which the chords cover the fraction `x` in [0,1) of the area. For uniform
  /// x, the density of u is the length of the chord over the area.
  float u_of_area(float x) const;

 private:
  // The length of the chords is linear in u between the corners that bound a slab.
  struct Slab {
    float u, width;
    float begin_length, end_length;
    float area_before;  // area of all slabs before this one, as a fraction of the polygon's
    float area;         // area of this slab, as a fraction of the polygon's
  };
  float length_at(float u) const;

  Vec3 origin_{0.0f}, along_{0.0f}, across_{0.0f};
  std::vector<Vec2> corners_;  // (along, across) from origin_; across in [0, extent_]
  std::vector<Slab> slabs_;
  float extent_ = 0;
};

/// A random chord for estimators that integrate along the whole chord.
struct WeightedChord {
  Chord chord;
  float pdf_u;  ///< density of the chord per unit length across the chords
};

/// Samples a chord by the uniform number u in [0,1). The chords are parallel to the light's longest
/// edge (`direction` = 0) or perpendicular to it (1). For a rectangle the density is, within a
/// factor of 2, uniform in the angle that the chords subtend at `from`; for other polygons it is
/// proportional to the length of the chord. The density is continuous over the light, because a
/// jump would lower the order of convergence. Returns nothing when `from` does not see the emitting
/// side, or where rounding leaves no chord.
std::optional<WeightedChord> sample_whole_chord(const AreaLight& light, const Vec3& from,
                                                int direction, float u);

/// A random chord with a distribution of points along it. Over all chords, the points are uniform
/// in the solid angle seen from the point for which the chord was sampled. They are uniform in area
/// for polygons that are no rectangles and for solid angles that are not usable.
struct ChordSample {
  Chord chord;
  float solid_angle;  ///< of the light, in steradians; 0 where points are uniform in area

  // Points are uniform in a measure of the chord. It is the parameter of the chord, or
  // y / sqrt(y^2 + line_distance2) with y relative to the foot of the point: the inner step of
  // Ureña et al. 2013. Close to the light its inverse needs double precision.
  double begin;           ///< y of the beginning of the chord
  double line_distance2;  ///< squared distance of the point from the line of the chord

  /// Returns the probability that a point of this chord lies in `part`.
  float share(const Interval& part) const;
  /// Inverts the distribution restricted to `parts`, of which there must be one. Returns the point,
  /// as a parameter of the chord, before which lies the fraction x in [0,1) of the probability.
  float parameter(std::span<const Interval> parts, float x) const;

 private:
  double measure(float t) const;
};

/// Samples a chord like sample_whole_chord, for estimators that use one point of the chord.
std::optional<ChordSample> sample_chord(const AreaLight& light, const Vec3& from, int direction,
                                        float u);

/// Returns the density, per steradian seen from `from`, of the point `q` of the light when
/// sample_chord samples the chord and ChordSample the point. It does not depend on the direction.
float chord_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q);

}  // namespace raytracing
