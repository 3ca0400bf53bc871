#pragma once

#include <cstdint>
#include <vector>

#include "raytracing/math/vec.h"

namespace raytracing {

/// Marks an absent index.
inline constexpr std::uint32_t kNone = 0xffffffffu;

/// A mesh whose faces keep all their corners, as an OBJ file states them. A quad that emits stays
/// one light; triangles are made from it only for the accelerator.
struct PolygonMesh {
  struct Corner {
    std::uint32_t position;        ///< index into `positions`
    std::uint32_t normal = kNone;  ///< index into `normals`, or kNone for a flat corner
  };
  struct Face {
    std::uint32_t first_corner;  ///< index into `corners`
    std::uint32_t corner_count;  ///< >= 3, counter-clockwise seen from the side of the normal
    std::uint32_t material;      ///< index into the list of materials that goes with the mesh
  };

  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< need not be of unit length
  std::vector<Corner> corners;
  std::vector<Face> faces;
};

/// Removes the positions that no corner uses.
void drop_unused_positions(PolygonMesh& mesh);

}  // namespace raytracing
