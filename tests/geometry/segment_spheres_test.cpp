#include <gtest/gtest.h>

#include "raytracing/geometry/occluder_tree.h"
#include "support/segment_reference.h"

namespace raytracing {
namespace {

// A ray that passes a sphere, or an end of it, within this distance may be occluded or not. The
// unit is the float spacing of the largest coordinate.
constexpr double kAllowed = 32;

double error_of(const SegmentScene& scene, const SegmentQuery& q) {
  const OccluderTree tree = scene.build();
  return worst_error(scene, q, tree.visible_part(q.p, q.a, q.d, {0, 1}), 400);
}

TEST(SegmentSpheres, EqualALoop) {
  TestRandom random(1);
  for (int round = 0; round < 6000; ++round) {
    SegmentScene scene;
    for (int i = 0; i <= round % 6; ++i)
      scene.spheres.push_back({random.in_cube(1), std::exp(random.between(-5, 0.5f))});
    const SegmentQuery q{random.in_cube(1), random.in_cube(1), random.in_cube(2)};
    ASSERT_LE(error_of(scene, q), kAllowed) << round;
  }
}

TEST(SegmentSpheres, EqualALoopAtEveryScale) {
  TestRandom random(2);
  for (const auto& [scale, offset] : {std::pair{1e-4f, 0.0f}, {1e5f, 0.0f}, {1.0f, 1e3f}})
    for (int round = 0; round < 1000; ++round) {
      const Vec3 at = offset * random.direction();
      SegmentScene scene;
      for (int i = 0; i < 3; ++i)
        scene.spheres.push_back(
            {at + scale * random.in_cube(1), scale * random.between(0.05f, 0.8f)});
      const SegmentQuery q{at + scale * random.in_cube(1), at + scale * random.in_cube(1),
                           scale * random.in_cube(1)};
      ASSERT_LE(error_of(scene, q), kAllowed) << scale << " " << offset << " " << round;
    }
}

TEST(SegmentSpheres, TogetherWithTriangles) {
  TestRandom random(3);
  for (int round = 0; round < 1000; ++round) {
    SegmentScene scene;
    for (int i = 0; i < 30; ++i) {
      const Vec3 at = random.in_cube(1);
      scene.add(at, at + random.in_cube(0.4f), at + random.in_cube(0.4f));
    }
    for (int i = 0; i < 3; ++i) scene.spheres.push_back({random.in_cube(1), 0.2f});
    const SegmentQuery q{random.in_cube(1.5f), random.in_cube(1.5f), random.in_cube(2)};
    ASSERT_LE(error_of(scene, q), kAllowed) << round;
  }
}

// Queries the segment from (-1, 2, 0) to (1, 2, 0) as seen from the origin.
IntervalSet seen(const Sphere& sphere) {
  SegmentScene scene;
  scene.spheres.push_back(sphere);
  return scene.build().visible_part(Vec3(0.0f), Vec3(-1, 2, 0), Vec3(2, 0, 0), {0, 1});
}

TEST(SegmentSpheres, WholeAndNothing) {
  const Sphere nothing[] = {{Vec3(0, 3, 0), 0.99f},                         // behind the segment
                            {Vec3(0, 3, 0), 0.25f}, {Vec3(0, 1, 2), 1.9f},  // beside the plane
                            {Vec3(0, -1, 0), 0.9f},                         // behind the point
                            {Vec3(2, 1, 0), 0.5f},                          // beside the segment
                            {Vec3(0, 1, 0), 3},  // around the point and the segment
                            {Vec3(0, 1, 0), 0}};
  for (const Sphere& sphere : nothing) EXPECT_EQ(seen(sphere).length(), 1) << sphere.radius;
  const Sphere all[] = {{Vec3(0, 1, 0), 0.9f},
                        {Vec3(0.0f), 0.5f},      // around the point alone
                        {Vec3(0, 2, 0), 1.5f}};  // around the segment alone
  for (const Sphere& sphere : all) EXPECT_TRUE(seen(sphere).empty()) << sphere.radius;
}

TEST(SegmentSpheres, TouchingThePlaneHidesAlmostNothing) {
  EXPECT_GE(seen({Vec3(0, 1, 0.5f), 0.5f}).length(), 1 - 2e-3f);
  EXPECT_GE(seen({Vec3(0, 3, 0), 1}).length(), 1 - 2e-3f);
}

// The angle between the axis and the tangents from the origin is asin(r / 1).
TEST(SegmentSpheres, TangentsBoundWhatIsHidden) {
  const IntervalSet set = seen({Vec3(0, 1, 0), 0.25f});
  ASSERT_EQ(set.intervals().size(), 2u);
  const double reach = 2 * std::tan(std::asin(0.25));
  EXPECT_NEAR(set.intervals()[0].end, 0.5 - reach / 2, 1e-6);
  EXPECT_NEAR(set.intervals()[1].begin, 0.5 + reach / 2, 1e-6);
}

}  // namespace
}  // namespace raytracing
