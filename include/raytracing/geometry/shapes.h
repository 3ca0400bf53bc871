#pragma once
// Rays, spheres and rectangles.

#include <cmath>
#include <optional>
#include <utility>

#include "raytracing/math/interval_set.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// A half line. Its direction need not be of unit length.
struct Ray {
  Vec3 origin;
  Vec3 direction;
};

/// Bounds the distance between a point computed on a surface and the surface that Embree
/// intersects, when no coordinate of the surface exceeds `max_coordinate` in absolute value. The
/// bound is a few dozen float spacings: it follows the rounding of the coordinates, not the scale
/// of the scene.
inline float position_error(float max_coordinate) { return 32 * 0x1p-24f * max_coordinate; }

/// Moves the surface point `p` by `error` towards the side of the unit normal `n`.
inline Vec3 offset_point(const Vec3& p, const Vec3& n, float error) { return p + error * n; }

/// A rectangle in space.
struct Rectangle {
  Vec3 corner;
  Vec3 x, y;     ///< unit directions of the edges, orthogonal to each other
  float width;   ///< length of the edge along x
  float height;  ///< length of the edge along y
};

struct Sphere {
  Vec3 center{0.0f};
  float radius = 1;

  /// The largest absolute value of a coordinate of any point of the sphere.
  float max_coordinate() const { return max_component(absolute(center)) + radius; }
};

/// Returns the two parameters at which the line through the ray meets the sphere, in any order, or
/// NaN where it misses. The discriminant is computed from the distance of the line to the centre,
/// which keeps its digits for far and small spheres (Haines et al. 2019, Ray Tracing Gems, chapter
/// 7).
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

/// Returns the two parameters in ascending order, or nothing where the line misses the sphere.
inline std::optional<std::pair<float, float>> intersect_line(const Sphere& sphere, const Ray& ray) {
  const auto [t0, t1] = line_crossings(sphere, ray);
  if (std::isnan(t1)) return std::nullopt;
  return t0 < t1 ? std::pair{t0, t1} : std::pair{t1, t0};
}

/// Subtracts from `visible` the part of the segment a + t d, t in [0,1], that the surface of the
/// sphere occludes from p.
void subtract_shadow(const Sphere& sphere, const Vec3& p, const Vec3& a, const Vec3& d,
                     IntervalSet& visible);

}  // namespace raytracing
