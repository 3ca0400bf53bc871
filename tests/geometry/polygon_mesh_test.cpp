#include "raytracing/geometry/polygon_mesh.h"

#include <gtest/gtest.h>

namespace raytracing {
namespace {

TEST(PolygonMesh, DropsThePositionsThatNoCornerUses) {
  PolygonMesh mesh;
  for (int i = 0; i < 6; ++i) mesh.positions.emplace_back(i, 10 * i, 0);
  mesh.corners = {{5, 7}, {1}, {3}, {3}, {4}, {1}};
  mesh.faces = {{0, 3, 0}, {3, 3, 0}};
  const PolygonMesh before = mesh;
  drop_unused_positions(mesh);
  EXPECT_EQ(mesh.positions.size(), 4u);
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    EXPECT_EQ(mesh.positions.at(mesh.corners[i].position),
              before.positions[before.corners[i].position]);
    EXPECT_EQ(mesh.corners[i].normal, before.corners[i].normal);
  }
  const std::vector<Vec3> kept = mesh.positions;
  drop_unused_positions(mesh);
  EXPECT_EQ(mesh.positions, kept);
}

TEST(PolygonMesh, WithoutFacesHasNoPositions) {
  PolygonMesh mesh;
  drop_unused_positions(mesh);
  mesh.positions = {Vec3(1.0f), Vec3(2.0f)};
  drop_unused_positions(mesh);
  EXPECT_TRUE(mesh.positions.empty());
}

}  // namespace
}  // namespace raytracing
