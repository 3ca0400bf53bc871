#include "raytracing/lights/chord_sample.h"

#include <cmath>

#include "raytracing/math/numeric.h"
#include "usable_solid_angle.h"

namespace raytracing {
namespace {

// A chord of a rectangle at the x that SphericalRectangle chooses; chords run along its y.
std::optional<ChordSample> sample_rectangle_chord(const Rectangle& r, const Vec3& from, float u) {
  const SphericalRectangle seen(r, from);
  if (!is_usable(seen.solid_angle())) return std::nullopt;
  const SphericalRectangle::Strip strip = seen.strip(u);
  return ChordSample{{r.corner + strip.x * r.x, r.y, r.height},
                     strip.pdf_x,
                     seen.solid_angle(),
                     strip.y_begin,
                     strip.line_distance2};
}

Rectangle transposed(const Rectangle& r) { return {r.corner, r.y, r.x, r.height, r.width}; }

}  // namespace

float ChordSample::measure(float t) const {
  if (solid_angle == 0) return t;
  const float y = begin + t * chord.length;
  return y / std::sqrt(y * y + line_distance2);
}

float ChordSample::share(const Interval& part) const {
  return (measure(part.end) - measure(part.begin)) / (measure(1) - measure(0));
}

float ChordSample::parameter(std::span<const Interval> parts, float x) const {
  float total = 0;
  for (const Interval& part : parts) total += measure(part.end) - measure(part.begin);
  float rest = x * total;
  std::size_t i = 0;
  for (; i + 1 < parts.size(); ++i) {
    const float size = measure(parts[i].end) - measure(parts[i].begin);
    if (rest < size) break;
    rest -= size;
  }
  const float m = measure(parts[i].begin) + rest;
  if (solid_angle == 0) return std::clamp(m, parts[i].begin, parts[i].end);
  const float y = m * std::sqrt(line_distance2) / safe_sqrt((1 - m) * (1 + m));
  return std::clamp((y - begin) / chord.length, parts[i].begin, parts[i].end);
}

std::optional<ChordSample> sample_chord(const AreaLight& light, const Vec3& from, int direction,
                                        float u) {
  if (!light.faces(from)) return std::nullopt;
  if (light.rectangle) {
    // The longest edge may be the rectangle's x or y.
    const bool along_y = (light.rectangle->height >= light.rectangle->width) == (direction == 0);
    const Rectangle r = along_y ? *light.rectangle : transposed(*light.rectangle);
    if (auto sample = sample_rectangle_chord(r, from, u)) return sample;
  }
  const ChordSet& chords = light.chords[direction];
  const std::optional<Chord> chord = chords.at(chords.u_of_area(u));
  if (!chord) return std::nullopt;
  return ChordSample{*chord, chord->length / light.area, 0, 0, 0};
}

float chord_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q) {
  return light.rectangle ? solid_angle_pdf_w(light, from, q) : area_pdf_w(light, from, q);
}

}  // namespace raytracing
