#include "transform.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace raytracing {
namespace {

/// Sine and cosine, exact at multiples of 90 degrees, so that axis-aligned walls stay aligned.
struct Angle {
  explicit Angle(double degrees) {
    const double quarters = std::nearbyint(degrees / 90);
    const double rest = (degrees - 90 * quarters) * (3.14159265358979323846 / 180);
    const double s = std::sin(rest), c = std::cos(rest);
    const double turn = quarters - 4 * std::floor(quarters / 4);  // 0, 1, 2 or 3
    sine = turn == 0 ? s : turn == 1 ? c : turn == 2 ? -s : -c;
    cosine = turn == 0 ? c : turn == 1 ? -s : turn == 2 ? -c : s;
  }
  double sine, cosine;
};

DVec3 rotated(DVec3 v, const Angle& x, const Angle& y, const Angle& z) {
  v = {v.x, x.cosine * v.y - x.sine * v.z, x.sine * v.y + x.cosine * v.z};
  v = {y.cosine * v.x + y.sine * v.z, v.y, y.cosine * v.z - y.sine * v.x};
  v = {z.cosine * v.x - z.sine * v.y, z.sine * v.x + z.cosine * v.y, v.z};
  return v;
}

}  // namespace

void apply(const Transform& transform, PolygonMesh& mesh) {
  const Angle x(transform.rotate.x), y(transform.rotate.y), z(transform.rotate.z);
  for (Vec3& position : mesh.positions) {
    const DVec3 scaled = transform.scale * DVec3(position);
    position = Vec3(rotated(scaled, x, y, z) + transform.translate);
  }
  for (Vec3& normal : mesh.normals) {
    // The inverse transpose of rotation times scale is rotation times 1 / scale.
    const DVec3 moved = rotated(DVec3(normal) / transform.scale, x, y, z);
    const double norm = length(moved);
    if (norm > 0) normal = Vec3(moved / norm);
  }
  const DVec3& s = transform.scale;
  const int mirrors = (s.x < 0 ? 1 : 0) + (s.y < 0 ? 1 : 0) + (s.z < 0 ? 1 : 0);
  if (mirrors % 2 == 0) return;
  for (const PolygonMesh::Face& face : mesh.faces) {
    const auto first = mesh.corners.begin() + static_cast<std::ptrdiff_t>(face.first_corner);
    std::reverse(first, first + static_cast<std::ptrdiff_t>(face.corner_count));
  }
}

}  // namespace raytracing
