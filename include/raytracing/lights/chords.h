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

/// The parallel chords of a planar convex polygon. All run along one direction; the coordinate u
/// counts across them, in the plane, from 0 to extent().
class ChordSet {
 public:
  ChordSet() = default;
  /// `direction` is of unit length and lies in the polygon's plane, whose unit normal is `normal`.
  ChordSet(std::span<const Vec3> corners, const Vec3& normal, const Vec3& direction);

  float extent() const { return extent_; }
  /// The chord at u in [0, extent()]; nothing where the line misses the polygon by rounding.
  std::optional<Chord> at(float u) const;
  /// The u below which the chords make up the share `x` in [0,1) of the polygon's area: for uniform
  /// x, its density is the chord's length over the area.
  float u_of_area(float x) const;

 private:
  // Between the u of neighbouring corners the chord's length runs linearly.
  struct Slab {
    float u, width;
    float begin_length, end_length;
    float area_before;  // of all slabs before, as a share of the whole
    float area;         // likewise
  };
  float length_at(float u) const;

  Vec3 origin_{0.0f}, along_{0.0f}, across_{0.0f};
  std::vector<Vec2> corners_;  // (along, across) from origin_; across in [0, extent_]
  std::vector<Slab> slabs_;
  float extent_ = 0;
};

}  // namespace raytracing
