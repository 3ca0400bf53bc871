#pragma once

#include <cmath>
#include <optional>
#include <utility>

#include "raytracing/geometry/ray.h"
#include "raytracing/math/vec.h"

namespace raytracing {

struct Sphere {
  Vec3 center{0.0f};
  float radius = 1;

  /// The largest coordinate, in size, of any of its points.
  float max_coordinate() const { return max_component(absolute(center)) + radius; }
};

/// Both ray parameters at which the line of the ray meets the sphere, in any order; NaN where it
/// does not. The discriminant is formed from the line's distance to the centre, which loses no
/// digits for far or small spheres (Haines et al. 2019, Ray Tracing Gems, chapter 7).
inline std::pair<float, float> line_crossings(const Sphere& sphere, const Ray& ray) {
  const Vec3 f = ray.origin - sphere.center;
  const float a = dot(ray.direction, ray.direction);
  const float b = -dot(f, ray.direction);
  const Vec3 closest = f + (b / a) * ray.direction;
  const float discriminant = sphere.radius * sphere.radius - dot(closest, closest);
  const float c = dot(f, f) - sphere.radius * sphere.radius;
  const float q = b + std::copysign(std::sqrt(a) * std::sqrt(discriminant), b);
  return {c / q, q / a};
}

/// The same, the nearer first; nothing where the line misses.
inline std::optional<std::pair<float, float>> intersect_line(const Sphere& sphere, const Ray& ray) {
  const auto [t0, t1] = line_crossings(sphere, ray);
  if (std::isnan(t1)) return std::nullopt;
  return t0 < t1 ? std::pair{t0, t1} : std::pair{t1, t0};
}

}  // namespace raytracing
