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

/// Both ray parameters (near, far) at which the line of the ray meets the sphere. The discriminant
/// is formed from the line's distance to the centre, which loses no digits for far or small spheres
/// (Haines et al. 2019, Ray Tracing Gems, chapter 7).
inline std::optional<std::pair<float, float>> intersect_line(const Sphere& sphere,
                                                             const Ray& ray) {
  const Vec3 f = ray.origin - sphere.center;
  const float a = dot(ray.direction, ray.direction);
  const float b = -dot(f, ray.direction);
  const Vec3 closest = f + (b / a) * ray.direction;
  const float discriminant = sphere.radius * sphere.radius - dot(closest, closest);
  if (!(discriminant >= 0)) return std::nullopt;
  const float c = dot(f, f) - sphere.radius * sphere.radius;
  const float q = b + std::copysign(std::sqrt(a * discriminant), b);
  const float t0 = c / q;
  const float t1 = q / a;
  return t0 < t1 ? std::pair{t0, t1} : std::pair{t1, t0};
}

}  // namespace raytracing
