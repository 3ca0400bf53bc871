#include "raytracing/geometry/polygon_mesh.h"

#include <algorithm>

namespace raytracing {

void drop_unused_positions(PolygonMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const PolygonMesh::Corner& corner : mesh.corners) used[corner.position] = true;
  if (std::all_of(used.begin(), used.end(), [](bool is_used) { return is_used; })) return;
  std::vector<std::uint32_t> place(used.size(), kNone);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    mesh.positions[kept] = mesh.positions[i];
    place[i] = kept++;
  }
  mesh.positions.resize(kept);
  for (PolygonMesh::Corner& corner : mesh.corners) corner.position = place[corner.position];
}

}  // namespace raytracing
