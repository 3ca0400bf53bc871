#include "raytracing/lights/chords.h"

#include <algorithm>
#include <limits>

namespace raytracing {

ChordSet::ChordSet(std::span<const Vec3> corners, const Vec3& normal, const Vec3& direction)
    : origin_(corners[0]), along_(direction), across_(cross(normal, direction)) {
  float lowest = 0, highest = 0;
  for (const Vec3& corner : corners) {
    const Vec3 d = corner - origin_;
    corners_.emplace_back(dot(d, along_), dot(d, across_));
    lowest = std::min(lowest, corners_.back().y);
    highest = std::max(highest, corners_.back().y);
  }
  origin_ += lowest * across_;
  for (Vec2& corner : corners_) corner.y -= lowest;
  extent_ = highest - lowest;
}

std::optional<Chord> ChordSet::at(float u) const {
  float first = std::numeric_limits<float>::infinity(), last = -first;
  Vec2 a = corners_.back();
  for (const Vec2& b : corners_) {
    if ((a.y <= u) != (b.y <= u)) {
      const float s = a.x + (b.x - a.x) * ((u - a.y) / (b.y - a.y));
      first = std::min(first, s);
      last = std::max(last, s);
    }
    a = b;
  }
  if (!(last > first)) return std::nullopt;
  return Chord{origin_ + first * along_ + u * across_, along_, last - first};
}

}  // namespace raytracing
