#include "raytracing/lights/chord.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "raytracing/lights/area_light.h"
#include "raytracing/math/numeric.h"
#include "raytracing/sampling/spherical.h"

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
    // The lengths at the ends are extrapolated from inside, because the length may be discontinuous
    // at the border to another slab.
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
  // This solves begin v + (end - begin) v^2 / 2 = share (begin + end) / 2 for v in [0,1] without
  // cancellation.
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

namespace {

// Samples the chord at the x of SphericalRectangle::sample. The chords are parallel to y of the
// rectangle.
std::optional<ChordSample> sample_rectangle_chord(const Rectangle& r, const Vec3& from, float u) {
  const SphericalRectangle seen(r, from);
  if (!is_usable_solid_angle(seen.solid_angle())) return std::nullopt;
  const SphericalRectangle::Strip strip = seen.strip(u);
  return ChordSample{{r.corner + strip.x * r.x, r.y, r.height},
                     static_cast<float>(seen.solid_angle()),
                     strip.y_begin,
                     strip.line_distance2};
}

// Samples a chord parallel to y of the rectangle, uniform in t = tan(phi / 2), where phi is the
// angle across the chords from the middle of the light. Since |t| <= 1, the density of the angle,
// proportional to 1 + t^2, is almost uniform. This converges as well as a uniform angle and needs
// no arc tangent.
WeightedChord angular_chord(const Rectangle& r, const Vec3& from, float u) {
  const Vec3 d = r.corner - from;
  const float x0 = dot(d, r.x), x1 = x0 + r.width;
  const float height = std::abs(dot(d, cross(r.x, r.y))), height2 = height * height;
  const float r0 = std::sqrt(height2 + x0 * x0), r1 = std::sqrt(height2 + x1 * x1);
  // These are the tangents of a half and a quarter of the whole angle.
  const float half = height * r.width / (height2 + plus_product_of_roots(height2, x0, x1, r0 * r1));
  const float quarter = half / (1 + std::sqrt(1 + half * half));
  const float t = (2 * u - 1) * quarter;
  // The direction of the middle, proportional to (height, x), is rotated by phi.
  const Vec2 middle(height * (r0 + r1), x0 * r1 + x1 * r0);
  const Vec2 turned = complex_product(middle, Vec2(1 - t * t, 2 * t));
  const float x = std::clamp(height * turned.y / turned.x, x0, x1);
  return {{r.corner + (x - x0) * r.x, r.y, r.height},
          height * (1 + t * t) / (4 * quarter * (height2 + x * x))};
}

Rectangle transposed(const Rectangle& r) { return {r.corner, r.y, r.x, r.height, r.width}; }

// Returns the rectangle with y parallel to the chords. The longest edge may be x or y.
Rectangle along_chords(const Rectangle& r, int direction) {
  return (r.height >= r.width) == (direction == 0) ? r : transposed(r);
}

std::optional<WeightedChord> chord_by_area(const AreaLight& light, int direction, float u) {
  const ChordSet& chords = light.chords[direction];
  const std::optional<Chord> chord = chords.at(chords.u_of_area(u));
  if (!chord) return std::nullopt;
  return WeightedChord{*chord, chord->length / light.area};
}

}  // namespace

std::optional<WeightedChord> sample_whole_chord(const AreaLight& light, const Vec3& from,
                                                int direction, float u) {
  if (!light.faces(from)) return std::nullopt;
  if (!light.rectangle) return chord_by_area(light, direction, u);
  const WeightedChord result = angular_chord(along_chords(*light.rectangle, direction), from, u);
  // A point in the plane of the light, up to rounding, has no finite density.
  if (!(result.pdf_u > 0 && std::isfinite(result.pdf_u))) return std::nullopt;
  return result;
}

double ChordSample::measure(float t) const {
  const auto d = static_cast<double>(t);
  if (solid_angle == 0) return d;
  const double y = begin + d * static_cast<double>(chord.length);
  return y / std::sqrt(y * y + line_distance2);
}

float ChordSample::share(const Interval& part) const {
  return static_cast<float>((measure(part.end) - measure(part.begin)) / (measure(1) - measure(0)));
}

float ChordSample::parameter(std::span<const Interval> parts, float x) const {
  double total = 0;
  for (const Interval& part : parts) total += measure(part.end) - measure(part.begin);
  double rest = static_cast<double>(x) * total;
  std::size_t i = 0;
  for (; i + 1 < parts.size(); ++i) {
    const double size = measure(parts[i].end) - measure(parts[i].begin);
    if (rest < size) break;
    rest -= size;
  }
  double t = measure(parts[i].begin) + rest;
  if (solid_angle > 0) {
    const double root =
        std::sqrt(line_distance2 / std::max((1 - t) * (1 + t), std::numeric_limits<double>::min()));
    t = (t * root - begin) / static_cast<double>(chord.length);
  }
  return static_cast<float>(
      std::clamp(t, static_cast<double>(parts[i].begin), static_cast<double>(parts[i].end)));
}

std::optional<ChordSample> sample_chord(const AreaLight& light, const Vec3& from, int direction,
                                        float u) {
  if (!light.faces(from)) return std::nullopt;
  if (light.rectangle) {
    const Rectangle r = along_chords(*light.rectangle, direction);
    if (auto sample = sample_rectangle_chord(r, from, u)) return sample;
  }
  const auto by_area = chord_by_area(light, direction, u);
  if (!by_area) return std::nullopt;
  return ChordSample{by_area->chord, 0, 0, 0};
}

float chord_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q) {
  return light.rectangle ? solid_angle_pdf_w(light, from, q) : area_pdf_w(light, from, q);
}

}  // namespace raytracing
