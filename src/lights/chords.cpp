#include "raytracing/lights/chords.h"

#include <algorithm>
#include <cmath>
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

  std::vector<float> levels;
  for (const Vec2& corner : corners_) levels.push_back(corner.y);
  std::sort(levels.begin(), levels.end());
  float total = 0;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    const float width = levels[i + 1] - levels[i];
    if (!(width > 0)) continue;
    // The lengths at the slab's ends, from inside: at its ends another slab may begin with a jump.
    const float a = length_at(levels[i] + width / 4), b = length_at(levels[i + 1] - width / 4);
    const float begin = std::max(0.0f, a - (b - a) / 2), end = std::max(0.0f, b + (b - a) / 2);
    const float area = width * (begin + end) / 2;
    slabs_.push_back({levels[i], width, begin, end, total, area});
    total += area;
  }
  for (Slab& slab : slabs_) {
    slab.area_before /= total;
    slab.area /= total;
  }
}

float ChordSet::length_at(float u) const {
  const std::optional<Chord> chord = at(u);
  return chord ? chord->length : 0.0f;
}

float ChordSet::u_of_area(float x) const {
  std::size_t i = 0;
  while (i + 1 < slabs_.size() && x >= slabs_[i + 1].area_before) ++i;
  const Slab& slab = slabs_[i];
  const float share = std::clamp((x - slab.area_before) / slab.area, 0.0f, 1.0f);
  // Solves begin v + (end - begin) v^2 / 2 = share (begin + end) / 2 for v in [0,1], in the form
  // that does not cancel.
  const float begin = slab.begin_length, end = slab.end_length;
  const float root = std::sqrt(begin * begin + share * (end * end - begin * begin));
  if (!(begin + root > 0)) return slab.u;
  return slab.u + slab.width * std::min(share * (begin + end) / (begin + root), 1.0f);
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
