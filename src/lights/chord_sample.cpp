#include "raytracing/lights/chord_sample.h"

#include <cmath>
#include <limits>

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
                     static_cast<float>(seen.solid_angle()),
                     strip.y_begin,
                     strip.line_distance2};
}

// Here chords run along y too. Uniform in t = tan(phi / 2), where phi is the angle across the
// chords, counted from the middle of the light: |t| <= 1, and the angle's density (1 + t^2) / 2 is
// almost uniform. As good as a uniform angle, without its arc tangent.
WeightedChord angular_chord(const Rectangle& r, const Vec3& from, float u) {
  const Vec3 d = r.corner - from;
  const float x0 = dot(d, r.x), x1 = x0 + r.width;
  const float height = std::abs(dot(d, cross(r.x, r.y))), height2 = height * height;
  const float r0 = std::sqrt(height2 + x0 * x0), r1 = std::sqrt(height2 + x1 * x1);
  // Tangents of a half and a quarter of the whole angle.
  const float half = height * r.width / (height2 + plus_product_of_roots(height2, x0, x1, r0 * r1));
  const float quarter = half / (1 + std::sqrt(1 + half * half));
  const float t = (2 * u - 1) * quarter;
  // The direction of the middle, (height, x) up to a factor, turned by phi.
  const Vec2 middle(height * (r0 + r1), x0 * r1 + x1 * r0);
  const Vec2 turned = complex_product(middle, Vec2(1 - t * t, 2 * t));
  const float x = std::clamp(height * turned.y / turned.x, x0, x1);
  return {{r.corner + (x - x0) * r.x, r.y, r.height},
          height * (1 + t * t) / (4 * quarter * (height2 + x * x))};
}

Rectangle transposed(const Rectangle& r) { return {r.corner, r.y, r.x, r.height, r.width}; }

// The light's rectangle, its y along the chords. The longest edge may be its x or y.
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
  // In the light's own plane, but for rounding, there is no density.
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
  return ChordSample{by_area->chord, by_area->pdf_u, 0, 0, 0};
}

float chord_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q) {
  return light.rectangle ? solid_angle_pdf_w(light, from, q) : area_pdf_w(light, from, q);
}

}  // namespace raytracing
