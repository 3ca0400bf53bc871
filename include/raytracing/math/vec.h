#pragma once
// Vectors and orthonormal frames. This is the only file that includes and configures GLM.

#include <cmath>

#define GLM_FORCE_XYZW_ONLY
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace raytracing {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using DVec2 = glm::dvec2;
using DVec3 = glm::dvec3;
/// Linear RGB radiance, reflectance or throughput.
using Rgb = glm::vec3;

using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;

inline float max_component(const Vec3& v) { return glm::max(v.x, glm::max(v.y, v.z)); }
inline Vec3 absolute(const Vec3& v) { return {glm::abs(v.x), glm::abs(v.y), glm::abs(v.z)}; }
/// Multiplies two complex numbers. The product of two unit numbers adds their angles.
template <class T>
glm::vec<2, T> complex_product(const glm::vec<2, T>& a, const glm::vec<2, T>& b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
inline bool is_black(const Rgb& c) { return c.x == 0 && c.y == 0 && c.z == 0; }
template <class T>
bool is_finite(const glm::vec<3, T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A right-handed orthonormal frame whose z axis is the normal.
struct Frame {
  Vec3 x, y, z;

  /// Builds a frame around the unit vector `n` without branches (Duff et al. 2017, listing 3).
  static Frame around(const Vec3& n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    return {
        {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
  }

  Vec3 to_local(const Vec3& w) const { return {dot(w, x), dot(w, y), dot(w, z)}; }
  Vec3 to_world(const Vec3& w) const { return w.x * x + w.y * y + w.z * z; }
};

}  // namespace raytracing
