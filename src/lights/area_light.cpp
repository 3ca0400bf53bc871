#include "raytracing/lights/area_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/math/numeric.h"
#include "raytracing/sampling/spherical.h"
#include "raytracing/sampling/warp.h"

namespace raytracing {
namespace {

Vec3 longest_edge(std::span<const Vec3> corners) {
  Vec3 best(0.0f);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 edge = corners[(i + 1) % corners.size()] - corners[i];
    if (dot(edge, edge) > dot(best, best)) best = edge;
  }
  return normalize(best);
}

// Returns true when the points are equal up to a few roundings of their coordinates.
bool same_point(const Vec3& a, const Vec3& b, float error) {
  return max_component(absolute(a - b)) <= error;
}

// The triangles of the fan around the first corner make up the polygon.
std::size_t fan_size(const AreaLight& light) { return light.corners.size() - 2; }
std::array<Vec3, 3> fan_triangle(const AreaLight& light, std::size_t i) {
  return {light.corners[0], light.corners[i + 1], light.corners[i + 2]};
}

float fan_area(const AreaLight& light, std::size_t i) {
  const auto [a, b, c] = fan_triangle(light, i);
  return std::max(0.0f, dot(cross(b - a, c - a), light.normal) / 2);
}

double fan_solid_angle(const AreaLight& light, const Vec3& from) {
  double sum = 0;
  for (std::size_t i = 0; i < fan_size(light); ++i)
    sum += SphericalTriangle(fan_triangle(light, i), from).solid_angle();
  return sum;
}

// Samples a triangle of the fan with a probability proportional to its weight. The random number u
// becomes one for the triangle. The sum of the weights is `total`, up to rounding.
template <class Weight>
std::size_t choose_from_fan(const AreaLight& light, double total, float& u, const Weight& weight) {
  double rest = static_cast<double>(u) * total;
  for (std::size_t i = 0;; ++i) {
    const double own = weight(i);
    if (rest < own || i + 1 == fan_size(light)) {
      const double fraction = own > 0 ? rest / own : 0;
      u = static_cast<float>(std::clamp(fraction, 0.0, static_cast<double>(kOneMinus)));
      return i;
    }
    rest -= own;
  }
}

std::optional<SolidAngleSample> sample_by_area(const AreaLight& light, const Vec3& from,
                                               const Vec2& u) {
  const Vec3 q = sample_area(light, u);
  return SolidAngleSample{q, area_pdf_w(light, from, q), true};
}

}  // namespace

AreaLight::AreaLight(std::span<const Vec3> polygon, const Rgb& radiance)
    : corners(polygon.begin(), polygon.end()), Le(radiance) {
  const DVec3 twice_area = newell_normal(polygon);
  area = static_cast<float>(length(twice_area) / 2);
  normal = Vec3(normalize(twice_area));
  float max_coordinate = 0;
  for (const Vec3& c : corners)
    max_coordinate = std::max(max_coordinate, max_component(absolute(c)));
  error = position_error(max_coordinate);
  const Vec3 along = longest_edge(corners);
  chords = {ChordSet(corners, normal, along), ChordSet(corners, normal, cross(normal, along))};

  if (corners.size() != 4 || !same_point(corners[0] + corners[2], corners[1] + corners[3], error))
    return;
  const Vec3 x = corners[1] - corners[0], y = corners[3] - corners[0];
  parallelogram = Parallelogram{corners[0], x, y};
  if (std::abs(dot(normalize(x), normalize(y))) < 1e-6f)
    rectangle = Rectangle{corners[0], normalize(x), normalize(y), length(x), length(y)};
}

bool AreaLight::faces(const Vec3& from) const { return dot(from - corners[0], normal) > 0; }

float AreaLight::power() const { return kPi * area * (Le.x + Le.y + Le.z) / 3; }

Vec3 sample_fan(const AreaLight& light, const Vec2& u) {
  Vec2 v = u;
  std::size_t i = 0;
  if (fan_size(light) > 1)
    i = choose_from_fan(light, static_cast<double>(light.area), v.x,
                        [&](std::size_t k) { return fan_area(light, k); });
  const auto [a, b, c] = fan_triangle(light, i);
  const Vec2 w = square_to_triangle(v);
  return a + w.x * (b - a) + w.y * (c - a);
}

std::optional<SolidAngleSample> sample_solid_angle(const AreaLight& light, const Vec3& from,
                                                   const Vec2& u) {
  if (!light.faces(from)) return std::nullopt;
  if (light.rectangle) {
    const SphericalRectangle seen(*light.rectangle, from);
    if (!is_usable_solid_angle(seen.solid_angle())) return sample_by_area(light, from, u);
    return SolidAngleSample{seen.sample(u), static_cast<float>(1 / seen.solid_angle())};
  }
  const double solid_angle = fan_solid_angle(light, from);
  if (!is_usable_solid_angle(solid_angle)) return sample_by_area(light, from, u);
  Vec2 v = u;
  std::optional<SphericalTriangle> chosen;
  choose_from_fan(light, solid_angle, v.x, [&](std::size_t i) {
    return chosen.emplace(fan_triangle(light, i), from).solid_angle();
  });
  const std::optional<Vec3> q = chosen->sample(v);
  if (!q) return std::nullopt;
  return SolidAngleSample{*q, static_cast<float>(1 / solid_angle)};
}

float solid_angle_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q) {
  if (!light.faces(from)) return 0;
  const double solid_angle = light.rectangle
                                 ? SphericalRectangle(*light.rectangle, from).solid_angle()
                                 : fan_solid_angle(light, from);
  return is_usable_solid_angle(solid_angle) ? static_cast<float>(1 / solid_angle)
                                            : area_pdf_w(light, from, q);
}

}  // namespace raytracing
