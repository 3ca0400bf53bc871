#pragma once
// Planar polygons and meshes of them.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raytracing/math/vec.h"

namespace raytracing {

/// Marks an absent index.
inline constexpr std::uint32_t kNone = 0xffffffffu;

/// A mesh of polygons with any number of corners, as OBJ files store them. A quad that emits light
/// thus remains one area light; only the acceleration structures split it into triangles.
struct PolygonMesh {
  struct Corner {
    std::uint32_t position;        ///< index into `positions`
    std::uint32_t normal = kNone;  ///< index into `normals`, or kNone for a flat corner
  };
  struct Face {
    std::uint32_t first_corner;  ///< index into `corners`
    std::uint32_t corner_count;  ///< >= 3, counter-clockwise seen from the side of the normal
    std::uint32_t material;      ///< index into the list of materials of the mesh
  };

  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< need not be of unit length
  std::vector<Corner> corners;
  std::vector<Face> faces;
};

/// Removes the positions that no corner uses.
void drop_unused_positions(PolygonMesh& mesh);

/// Returns the area-weighted normal of a closed polygon by Newell's method, in double precision
/// relative to the first corner. The length of the normal is twice the area of a planar polygon.
DVec3 newell_normal(std::span<const Vec3> corners);

/// Returns true when the polygon is convex as seen along its Newell normal. Collinear corners are
/// allowed.
bool is_convex(std::span<const Vec3> corners);

/// Splits a simple polygon, convex or concave, into corner_count - 2 triangles by ear clipping. The
/// returned indices refer to `corners` and keep the orientation of the polygon; the signed areas of
/// the triangles along the Newell normal sum to that of the polygon. A polygon that intersects
/// itself is split into as many triangles, which may then overlap.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace raytracing
