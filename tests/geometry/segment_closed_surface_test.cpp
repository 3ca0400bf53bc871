// No light leaks through edges that triangles share; degenerate cases of segment queries.
#include <gtest/gtest.h>

#include <stdexcept>

#include "raytracing/geometry/occluder_tree.h"
#include "raytracing/math/vec.h"
#include "support/segment_reference.h"

namespace raytracing {
namespace {

constexpr double kAllowed = 32;  // in float spacings of the largest coordinate

std::array<Vec3, 3> random_axes(TestRandom& random) {
  const Frame frame = Frame::around(random.direction());
  return {frame.x, frame.y, cross(frame.x, frame.y)};
}

IntervalSet visible(const OccluderTree& tree, const SegmentQuery& q) {
  return tree.visible_part(q.p, q.a, q.d, {0, 1});
}

// A closed convex surface occludes one interval and leaves at most one piece on each side.
TEST(SegmentQuery, ConvexSurfacesHideOneIntervalWithoutSlits) {
  TestRandom random(1);
  int whole = 0, partial = 0;
  for (int round = 0; round < 3000; ++round) {
    SegmentScene scene;
    const float scale = std::exp2(random.between(-12, 12));
    const Sphere ball{scale * random.in_cube(3), scale * random.between(0.2f, 1)};
    add_tessellated_sphere(scene, ball, round % 5, random_axes(random));
    const OccluderTree tree = scene.build();
    for (int i = 0; i < 10; ++i) {
      const Vec3 to = random.direction();
      const Vec3 p = ball.center - random.between(1.05f, 5.0f) * ball.radius * to;
      const Vec3 a = ball.center + ball.radius * (random.between(1.1f, 4.0f) * to +
                                                  random.between(0.1f, 2) * random.direction());
      const SegmentQuery q{p, a, scale * random.between(0.01f, 2) * random.direction()};
      const IntervalSet set = visible(tree, q);
      Pieces hidden = hidden_pieces(scene, q);
      std::sort(hidden.begin(), hidden.end());
      double begin = 1, end = 0;
      for (const auto& [first, last] : hidden) {
        begin = std::min(begin, first);
        end = std::max(end, last);
      }
      ASSERT_LE(set.intervals().size(), 2u) << round;
      ASSERT_LE(worst_error(scene, q, set), kAllowed) << round;
      if (begin <= 0 && end >= 1) {
        ++whole;
      } else if (begin < end) {
        ++partial;
      }
      for (const Interval& part : set.intervals())  // beside the occluded interval, not in it
        ASSERT_TRUE(part.begin == 0 || part.end == 1) << round;
    }
  }
  EXPECT_GT(whole, 3000);
  EXPECT_GT(partial, 1000);
}

// A flat mesh with shared corners separates the point and the segment and exceeds their hull.
TEST(SegmentQuery, FlatNetsHideEverything) {
  TestRandom random(2);
  for (int round = 0; round < 3000; ++round) {
    const auto [x, y, z] = random_axes(random);
    const Vec3 middle = random.in_cube(4);
    const std::uint32_t n = 1 + static_cast<std::uint32_t>(random.bits() % 12);
    SegmentScene scene;
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j) {
        const Vec2 at = 6.0f * Vec2(i, j) / static_cast<float>(n) - 3.0f;
        scene.positions.push_back(middle + at.x * x + at.y * y);
      }
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t k = i * (n + 1) + j;
        scene.triangles.push_back({{k, k + 1, k + n + 2}});
        scene.triangles.push_back({{k, k + n + 2, k + n + 1}});
      }
    const OccluderTree tree = scene.build();
    const auto near_axis = [&](float height) {
      return middle + height * z + random.between(-1, 1) * x + random.between(-1, 1) * y;
    };
    for (int i = 0; i < 10; ++i) {
      const Vec3 p = near_axis(random.between(0.01f, 2)), a = near_axis(-random.between(0.01f, 2));
      const Vec3 d = near_axis(-random.between(0.01f, 2)) - a;
      ASSERT_TRUE(visible(tree, {p, a, d}).empty()) << round;
      // The segment intersects the mesh, and one piece is visible, up to the intersection.
      const Vec3 across = near_axis(random.between(0.1f, 2)) - a;
      const IntervalSet part = visible(tree, {p, a, across});
      ASSERT_EQ(part.intervals().size(), 1u) << round;
      ASSERT_EQ(part.hull().end, 1.0f) << round;
      // A point close to the line of the segment does not define a plane with it.
      const float sine = length(cross(a - p, across)) / (length(a - p) * length(across));
      if (sine < 0.02f) continue;
      ASSERT_LE(worst_error(scene, {p, a, across}, part), 4 * kAllowed) << round;
    }
  }
}

const SegmentQuery kQuery{Vec3(0, 0, 0), Vec3(-1, 2, 0), Vec3(2, 0, 0)};

void expect_all(const IntervalSet& set) {
  ASSERT_EQ(set.intervals().size(), 1u);
  EXPECT_EQ(set.hull().begin, 0.0f);
  EXPECT_EQ(set.hull().end, 1.0f);
}

TEST(SegmentQuery, EmptyScenesHideNothing) {
  const OccluderTree empty = SegmentScene().build();
  expect_all(visible(empty, kQuery));
  const IntervalSet part = empty.visible_part(kQuery.p, kQuery.a, kQuery.d, {0.25f, 0.5f});
  EXPECT_EQ(part.hull().begin, 0.25f);
  EXPECT_EQ(part.hull().end, 0.5f);
}

TEST(SegmentQuery, ATreeThatWasNotBuiltAnswersNothing) {
  EXPECT_THROW(visible(OccluderTree(), kQuery), std::logic_error);
}

// One triangle, for which the tree is a single leaf, occludes the middle half.
TEST(SegmentQuery, LoneTriangle) {
  SegmentScene scene;
  scene.add(Vec3(-0.25f, 1, -1), Vec3(-0.25f, 1, 1), Vec3(0.75f, 1, 0));
  const IntervalSet set = visible(scene.build(), kQuery);
  ASSERT_EQ(set.intervals().size(), 1u);
  // The triangle spans x = -0.25 .. 0.75 at depth 1, or -0.5 .. 1.5 on the segment.
  EXPECT_EQ(set.hull().begin, 0.0f);
  EXPECT_EQ(set.hull().end, 0.25f);
}

TEST(SegmentQuery, WhatLiesInThePlaneHidesNothing) {
  SegmentScene scene;
  scene.add(Vec3(-0.5f, 1, 0), Vec3(0.5f, 1, 0), Vec3(0, 1.5f, 0));
  expect_all(visible(scene.build(), kQuery));
}

// A face that touches the plane with an edge occludes from one side of the plane only. Of the two
// faces of such an edge exactly one occludes, so that none is counted twice or never.
TEST(SegmentQuery, TouchingThePlaneByACornerOrAnEdge) {
  for (float side : {1.0f, -1.0f}) {
    SegmentScene corner;
    corner.add(Vec3(0, 1, 0), Vec3(-0.5f, 1, side), Vec3(0.5f, 1, side));
    expect_all(visible(corner.build(), kQuery));
  }
  SegmentScene both;
  int hiding = 0;
  for (float side : {1.0f, -1.0f}) {
    SegmentScene one;
    for (SegmentScene* scene : {&one, &both})
      scene->add(Vec3(-0.25f, 1, 0), Vec3(0.25f, 1, 0), Vec3(0, 1, side));
    hiding += visible(one.build(), kQuery).length() < 1;
  }
  EXPECT_EQ(hiding, 1);
  const IntervalSet set = visible(both.build(), kQuery);
  ASSERT_EQ(set.intervals().size(), 2u);
  EXPECT_EQ(set.intervals()[0].end, 0.25f);
  EXPECT_EQ(set.intervals()[1].begin, 0.75f);
}

TEST(SegmentQuery, DegenerateTrianglesHideNothing) {
  SegmentScene scene;
  scene.add(Vec3(0, 1, 0), Vec3(0, 1, 0), Vec3(0, 1, 0));
  scene.add(Vec3(0, 1, -1), Vec3(0, 1, -1), Vec3(0.3f, 1, 1));
  scene.add(Vec3(0, 1, -1), Vec3(0, 1, 1), Vec3(0, 1, -1));
  scene.add(Vec3(-1, 1, -1), Vec3(0, 1, 0), Vec3(1, 1, 1));
  scene.add(Vec3(0.1f, 1, -1), Vec3(0.1f, 1, 0.5f), Vec3(0.1f, 1, 1));
  const IntervalSet set = visible(scene.build(), kQuery);
  EXPECT_NEAR(set.length(), 1, 1e-6);
  TestRandom random(3);
  for (int round = 0; round < 2000; ++round) {
    SegmentScene lines;
    for (int i = 0; i < 20; ++i) {
      const Vec3 a = random.in_cube(1), b = random.in_cube(1);
      i % 2 ? lines.add(a, b, i % 4 == 1 ? a : b) : lines.add(a, 0.5f * (a + b), b);
    }
    const SegmentQuery q{random.in_cube(1), random.in_cube(1), random.in_cube(1)};
    ASSERT_LE(worst_error(lines, q, visible(lines.build(), q)), kAllowed) << round;
  }
}

TEST(SegmentQuery, SegmentsWithoutAnAngleAreVisible) {
  SegmentScene scene;
  add_tessellated_sphere(scene, {Vec3(0, 1, 0), 0.5f}, 2,
                         {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)});
  const OccluderTree tree = scene.build();
  expect_all(visible(tree, {Vec3(0.0f), Vec3(0, 2, 0), Vec3(0.0f)}));     // of zero length
  expect_all(visible(tree, {Vec3(0.0f), Vec3(0, 2, 0), Vec3(0, 1, 0)}));  // in line with the point
  expect_all(visible(tree, {Vec3(0.0f), Vec3(0, 0, 0), Vec3(0, 1, 0)}));
}

// A point computed on a surface, offset like the origin of a ray, sees everything on its side of
// the surface and nothing behind.
TEST(SegmentQuery, ContactPointsDoNotHideThemselves) {
  TestRandom random(4);
  for (int round = 0; round < 4000; ++round) {
    const float scale = std::exp2(random.between(-10, 14));
    const Vec3 at = scale * random.in_cube(4);
    SegmentScene scene;
    const Vec3 b = at + scale * random.in_cube(1), c = at + scale * random.in_cube(1);
    scene.add(at, b, c);
    const Vec3 n = normalize(cross(b - at, c - at));
    const OccluderTree tree = scene.build();
    const Vec2 w = 0.45f * random.unit2() + 0.02f;
    const Vec3 on = at + w.x * (b - at) + w.y * (c - at);
    const Vec3 p = offset_point(on, n, position_error(max_component(absolute(at)) + 2 * scale));
    const auto above = [&] {
      const Vec3 v = random.direction();
      return on + scale * (dot(v, n) < 0 ? -v : v) + 0.01f * scale * n;
    };
    const Vec3 a = above(), d = above() - a;
    const IntervalSet set = visible(tree, {p, a, d});
    ASSERT_EQ(set.intervals().size(), 1u) << round;
    ASSERT_EQ(set.length(), 1.0f) << round;
  }
}

}  // namespace
}  // namespace raytracing
