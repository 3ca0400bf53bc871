#include "raytracing/lights/area_light.h"

#include <array>
#include <cmath>
#include <limits>

#include "raytracing/geometry/ray.h"
#include "raytracing/geometry/triangulate.h"
#include "raytracing/math/numeric.h"
#include "raytracing/sampling/warp.h"
#include "usable_solid_angle.h"

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

std::vector<float> fan_areas(std::span<const Vec3> corners, const Vec3& normal) {
  std::vector<float> areas;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vec3 twice = cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    areas.push_back(std::max(0.0f, dot(twice, normal) / 2));
  }
  return areas;
}

// Equality up to a few roundings of the coordinates themselves.
bool same_point(const Vec3& a, const Vec3& b, float error) {
  return max_component(absolute(a - b)) <= error;
}

std::array<Vec3, 3> fan_triangle(const AreaLight& light, std::uint32_t i) {
  return {light.corners[0], light.corners[i + 1], light.corners[i + 2]};
}

// Solid angles of the fan's triangles and their sum.
struct FanSolidAngles {
  std::vector<float> each;
  double sum = 0;
  FanSolidAngles(const AreaLight& light, const Vec3& from) {
    for (std::uint32_t i = 0; i < light.fan.size(); ++i) {
      const SphericalTriangle triangle(fan_triangle(light, i), from);
      each.push_back(static_cast<float>(triangle.solid_angle()));
      sum += triangle.solid_angle();
    }
  }
};

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
  fan = DiscreteDistribution(fan_areas(corners, normal));
  const Vec3 along = longest_edge(corners);
  chords = {ChordSet(corners, normal, along), ChordSet(corners, normal, cross(normal, along))};

  const Vec3 x = corners[1] - corners[0], y = corners.back() - corners[0];
  if (corners.size() != 4 || !same_point(corners[0] + corners[2], corners[1] + corners[3], error))
    return;
  parallelogram = Parallelogram{corners[0], x, y};
  if (std::abs(dot(normalize(x), normalize(y))) < 1e-6f)
    rectangle = Rectangle{corners[0], normalize(x), normalize(y), length(x), length(y)};
}

bool AreaLight::faces(const Vec3& from) const { return dot(from - corners[0], normal) > 0; }

float AreaLight::power() const { return kPi * area * (Le.x + Le.y + Le.z) / 3; }

Vec3 sample_fan(const AreaLight& light, const Vec2& u) {
  const auto choice = light.fan.sample(u.x);
  const auto [a, b, d] = fan_triangle(light, choice.index);
  const Vec2 w = square_to_triangle({choice.u, u.y});
  return a + w.x * (b - a) + w.y * (d - a);
}

std::optional<SolidAngleSample> sample_solid_angle(const AreaLight& light, const Vec3& from,
                                                   const Vec2& u) {
  if (!light.faces(from)) return std::nullopt;
  if (light.rectangle) {
    const SphericalRectangle seen(*light.rectangle, from);
    if (!is_usable(seen.solid_angle())) return sample_by_area(light, from, u);
    return SolidAngleSample{seen.sample(u), static_cast<float>(1 / seen.solid_angle())};
  }
  const FanSolidAngles seen(light, from);
  if (!is_usable(seen.sum)) return sample_by_area(light, from, u);
  const auto choice = DiscreteDistribution(seen.each).sample(u.x);
  const SphericalTriangle triangle(fan_triangle(light, choice.index), from);
  const std::optional<Vec3> q = triangle.sample({choice.u, u.y});
  if (!q) return std::nullopt;
  return SolidAngleSample{*q, static_cast<float>(1 / seen.sum)};
}

float solid_angle_pdf_w(const AreaLight& light, const Vec3& from, const Vec3& q) {
  if (!light.faces(from)) return 0;
  const double solid_angle = light.rectangle
                                 ? SphericalRectangle(*light.rectangle, from).solid_angle()
                                 : FanSolidAngles(light, from).sum;
  return is_usable(solid_angle) ? static_cast<float>(1 / solid_angle) : area_pdf_w(light, from, q);
}

}  // namespace raytracing
