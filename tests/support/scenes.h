#pragma once
// Builders of small scenes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/scene/scene.h"

namespace raytracing {

/// Puts a SceneDescription together, one polygon or sphere after the other.
class SceneMaker {
 public:
  std::uint32_t add_surface(const Material& material, const Rgb& Le = Rgb(0.0f)) {
    description.surfaces.push_back({"", material, Le});
    return static_cast<std::uint32_t>(description.surfaces.size() - 1);
  }

  /// A flat face; its normal follows from the order of the corners.
  void add_polygon(std::span<const Vec3> corners, std::uint32_t surface) {
    PolygonMesh mesh;
    mesh.faces.push_back({0, static_cast<std::uint32_t>(corners.size()), surface});
    for (const Vec3& corner : corners) {
      mesh.corners.push_back({static_cast<std::uint32_t>(mesh.positions.size())});
      mesh.positions.push_back(corner);
    }
    description.meshes.push_back(std::move(mesh));
  }

  void add_sphere(const Vec3& center, float radius, std::uint32_t surface) {
    description.spheres.push_back({center, radius, surface});
  }

  Scene build() const { return Scene(description, 1); }

  SceneDescription description;
};

/// The parallelogram center +- x +- y with the normal cross(x, y).
inline std::vector<Vec3> parallelogram(const Vec3& center, const Vec3& x, const Vec3& y) {
  return {center - x - y, center + x - y, center + x + y, center - x + y};
}

/// The polygon, turned round where its normal does not point to the side of `p`.
inline std::vector<Vec3> facing(std::vector<Vec3> polygon, const Vec3& p) {
  if (dot(newell_normal(polygon), DVec3(p) - DVec3(polygon[0])) < 0)
    return {polygon.rbegin(), polygon.rend()};
  return polygon;
}

/// The six sides of the cube [-half, half]^3, normals inward. Each is a single face.
inline PolygonMesh inward_box(float half, std::uint32_t surface) {
  PolygonMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-half, half}) {
      Vec3 center(0.0f), x(0.0f), y(0.0f);
      center[axis] = side;
      x[(axis + 1) % 3] = half;
      y[(axis + 2) % 3] = half;
      mesh.faces.push_back({static_cast<std::uint32_t>(mesh.corners.size()), 4, surface});
      for (const Vec3& corner : facing(parallelogram(center, x, y), Vec3(0.0f))) {
        mesh.corners.push_back({static_cast<std::uint32_t>(mesh.positions.size())});
        mesh.positions.push_back(corner);
      }
    }
  return mesh;
}

/// A closed mesh of 20 * 4^levels triangles with shared corners on the unit sphere; normals inward.
inline PolygonMesh inward_icosphere(int levels, std::uint32_t surface) {
  constexpr float g = std::numbers::phi_v<float>;
  PolygonMesh mesh;
  for (const Vec3& p : std::array<Vec3, 12>{{{-1, g, 0},
                                             {1, g, 0},
                                             {-1, -g, 0},
                                             {1, -g, 0},
                                             {0, -1, g},
                                             {0, 1, g},
                                             {0, -1, -g},
                                             {0, 1, -g},
                                             {g, 0, -1},
                                             {g, 0, 1},
                                             {-g, 0, -1},
                                             {-g, 0, 1}}})
    mesh.positions.push_back(normalize(p));
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Triangle> triangles{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                  {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                  {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                  {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) mesh.positions.push_back(normalize(mesh.positions[a] + mesh.positions[b]));
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Triangle& t : {Triangle{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
        finer.push_back(t);
    }
    triangles = std::move(finer);
  }
  for (const auto& [a, b, c] : triangles) {
    mesh.faces.push_back({static_cast<std::uint32_t>(mesh.corners.size()), 3, surface});
    for (const std::uint32_t corner : {a, c, b}) mesh.corners.push_back({corner});
  }
  return mesh;
}

}  // namespace raytracing
