#pragma once

#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// Scale, then rotate, then translate.
struct Transform {
  DVec3 scale{1.0};   ///< along x, y, z; none zero
  DVec3 rotate{0.0};  ///< degrees about x, then y, then z; right-handed
  DVec3 translate{0.0};
};

/// Moves a mesh. Normals follow the inverse transpose and become unit vectors. A transform that
/// mirrors reverses the corners of each face, so that winding and normals still agree. Computed in
/// double and rounded once. A coordinate beyond the range of a float becomes infinite.
void apply(const Transform& transform, PolygonMesh& mesh);

}  // namespace raytracing
