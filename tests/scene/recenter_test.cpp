// Scenes far from the origin are found and recentered without rounding.

#include <gtest/gtest.h>

#include "raytracing/scene/description.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

SceneDescription scene_at(const Vec3& place, float half, TestRandom& random) {
  SceneDescription scene;
  scene.meshes.emplace_back();
  for (int i = 0; i < 100; ++i) scene.meshes[0].positions.push_back(place + random.in_cube(half));
  scene.spheres = {{place, 0.1f * half, 0}};
  scene.camera.origin = place + Vec3(0.0f, 0.0f, half);
  scene.camera.target = place;
  return scene;
}

TEST(Recenter, MovingIsExact) {
  TestRandom random(1);
  for (const float distance : {5.0f, 100.0f, 1e6f, 3e7f}) {
    const Vec3 place = distance * Vec3(1.3f, -0.01f, -1);
    const SceneDescription far = scene_at(place, 1, random);
    const Recentering found = find_recentering(far);
    EXPECT_NEAR(found.origin.x, place.x, 1 + distance * 1e-6f);
    SceneDescription near = far;
    recenter(near, found.origin);
    for (std::size_t i = 0; i < far.meshes[0].positions.size(); ++i) {
      const Vec3& p = near.meshes[0].positions[i];
      EXPECT_EQ(DVec3(p) + DVec3(found.origin), DVec3(far.meshes[0].positions[i]));
      EXPECT_LE(max_component(absolute(p)), 5 + distance * 1e-6f);
    }
    EXPECT_EQ(DVec3(near.spheres[0].center) + DVec3(found.origin), DVec3(place));
    EXPECT_EQ(near.camera.origin - near.camera.target, far.camera.origin - far.camera.target);
  }
}

// The spacing of floats near 1.5e6 is 1/8.
TEST(Recenter, RoundingIsTheSpacingOverHalfTheSize) {
  TestRandom random(2);
  EXPECT_NEAR(find_recentering(scene_at({1.5e6f, 3, 0}, 10, random)).rounding, 0.0125f, 0.001f);
}

TEST(Recenter, NearScenesStayWhereTheyAre) {
  TestRandom random(3);
  for (const Vec3& place : {Vec3(0.0f), Vec3(2, 0, 0), Vec3(0, -3, 3)}) {
    const Recentering found = find_recentering(scene_at(place, 1, random));
    EXPECT_EQ(found.origin, Vec3(0.0f));
    EXPECT_EQ(found.rounding, 0);
  }
  EXPECT_EQ(find_recentering({}).origin, Vec3(0.0f));
}

}  // namespace
}  // namespace raytracing
