#include "raytracing/math/vec.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/statistics.h"

namespace raytracing {
namespace {

// Returns random normals, the axes with zeros of either sign, and normals next to -z, for which the
// branch-free formula would divide by small numbers if its sign were wrong.
std::vector<Vec3> normals() {
  std::vector<Vec3> result;
  for (float s : {1.0f, -1.0f})
    for (float zero : {0.0f, -0.0f}) {
      result.push_back({s, zero, zero});
      result.push_back({zero, s, zero});
      result.push_back({zero, zero, s});
    }
  for (float tilt : {1e-7f, 1e-5f, 1e-3f})
    for (float z : {1.0f, -1.0f}) {
      result.push_back(normalize(Vec3(tilt, -tilt, z)));
      result.push_back(normalize(Vec3(1, tilt, z * tilt)));
    }
  TestRandom random(1);
  for (int i = 0; i < 100000; ++i) result.push_back(random.direction());
  return result;
}

TEST(Frame, IsOrthonormalAndRightHanded) {
  for (const Vec3& n : normals()) {
    const Frame f = Frame::around(n);
    EXPECT_EQ(f.z, n);
    EXPECT_NEAR(length(f.x), 1, 4e-7);
    EXPECT_NEAR(length(f.y), 1, 4e-7);
    EXPECT_NEAR(dot(f.x, f.y), 0, 4e-7);
    EXPECT_NEAR(dot(f.x, n), 0, 4e-7);
    EXPECT_NEAR(dot(f.y, n), 0, 4e-7);
    EXPECT_LE(max_component(absolute(cross(f.x, f.y) - n)), 6e-7f);
    if (HasFailure()) FAIL() << n.x << " " << n.y << " " << n.z;
  }
}

TEST(Frame, LocalAndWorldAreInverse) {
  TestRandom random(2);
  for (const Vec3& n : normals()) {
    const Frame f = Frame::around(n);
    const Vec3 w = random.direction();
    EXPECT_LE(max_component(absolute(f.to_world(f.to_local(w)) - w)), 1e-6f);
    EXPECT_LE(max_component(absolute(f.to_local(f.to_world(w)) - w)), 1e-6f);
    EXPECT_LE(max_component(absolute(f.to_local(n) - Vec3(0, 0, 1))), 6e-7f);
    EXPECT_NEAR(f.to_local(w).z, dot(n, w), 2e-7);
    if (HasFailure()) FAIL() << n.x << " " << n.y << " " << n.z;
  }
}

}  // namespace
}  // namespace raytracing
