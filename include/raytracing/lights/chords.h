#pragma once

#include <optional>
#include <span>
#include <vector>

#include "raytracing/math/vec.h"

namespace raytracing {

/// The cut of a light by one line of a ChordSet.
struct Chord {
  Vec3 begin;      ///< its first end
  Vec3 direction;  ///< unit
  float length;

  Vec3 at(float t) const { return begin + (t * length) * direction; }  ///< t in [0,1]
};

/// The parallel chords of a planar convex polygon. All run along `direction`; the coordinate u
/// counts across them, in the plane, from 0 to extent().
class ChordSet {
 public:
  ChordSet() = default;
  /// `direction` is of unit length and lies in the polygon's plane, whose unit normal is `normal`.
  ChordSet(std::span<const Vec3> corners, const Vec3& normal, const Vec3& direction);

  float extent() const { return extent_; }
  /// The chord at u in [0, extent()]; nothing where the line misses the polygon by rounding.
  std::optional<Chord> at(float u) const;

 private:
  Vec3 origin_{0.0f}, along_{0.0f}, across_{0.0f};
  std::vector<Vec2> corners_;  // (along, across) from origin_; across in [0, extent_]
  float extent_ = 0;
};

}  // namespace raytracing
