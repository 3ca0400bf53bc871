#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "raytracing/geometry/polygon_mesh.h"

namespace raytracing {
namespace {

using Polygon = std::vector<Vec3>;

Polygon flat(std::initializer_list<Vec2> points) {
  Polygon polygon;
  for (const Vec2& p : points) polygon.emplace_back(p.x, p.y, 0.0f);
  return polygon;
}

struct Areas {
  double polygon = 0;   // area along the Newell normal
  double sum = 0;       // signed area of the triangles along the Newell normal
  double absolute = 0;  // exceeds the sum when triangles overlap
  int without_area = 0;
};

Areas areas_of(const Polygon& polygon) {
  Areas areas;
  const DVec3 normal = newell_normal(polygon);
  areas.polygon = length(normal) / 2;
  for (const auto& t : triangulate(polygon)) {
    const DVec3 a(polygon[t[0]]), b(polygon[t[1]]), c(polygon[t[2]]);
    const DVec3 twice = cross(b - a, c - a);
    areas.sum += dot(twice, normalize(normal)) / 2;
    areas.absolute += length(twice) / 2;
    if (length(twice) <= 1e-12 * length(normal)) ++areas.without_area;
  }
  return areas;
}

// A simple polygon must be covered once, by n - 2 triangles of the same orientation and its area.
void expect_covered(const Polygon& polygon, int without_area = 0, double tolerance = 1e-6) {
  const auto triangles = triangulate(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  std::set<std::uint32_t> used;
  for (const auto& t : triangles) {
    for (const std::uint32_t i : t) {
      ASSERT_LT(i, polygon.size());
      used.insert(i);
    }
  }
  EXPECT_EQ(used.size(), polygon.size()) << "a corner is in no triangle";
  const Areas areas = areas_of(polygon);
  EXPECT_NEAR(areas.sum / areas.polygon, 1, tolerance);
  EXPECT_NEAR(areas.absolute / areas.polygon, 1, tolerance);
  EXPECT_EQ(areas.without_area, without_area);
}

// Tests the polygon in each orientation of its plane, mirrored, and started at each corner.
void expect_covered_everywhere(const Polygon& polygon, int without_area = 0) {
  for (std::size_t start = 0; start < polygon.size(); ++start) {
    Polygon turned = polygon;
    std::rotate(turned.begin(), turned.begin() + start, turned.end());
    SCOPED_TRACE("start " + std::to_string(start));
    expect_covered(turned, without_area);
    for (const int axis : {0, 1, 2}) {
      Polygon other;
      for (const Vec3& p : turned) {
        Vec3 q(0.25f);
        q[axis] = p.x;
        q[(axis + 1) % 3] = p.y;
        other.push_back(q);
      }
      expect_covered(other, without_area);
      std::reverse(other.begin(), other.end());
      expect_covered(other, without_area);
    }
  }
}

TEST(Triangulate, TooFewCornersGiveNothing) {
  EXPECT_TRUE(triangulate({}).empty());
  EXPECT_TRUE(triangulate(flat({{0, 0}, {1, 0}})).empty());
}

TEST(Triangulate, TriangleStaysAsItIs) {
  const auto triangles = triangulate(flat({{0, 0}, {1, 0}, {0, 1}}));
  ASSERT_EQ(triangles.size(), 1u);
  EXPECT_EQ(triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST(Triangulate, ConvexPolygonsBecomeFans) {
  const auto triangles = triangulate(flat({{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  ASSERT_EQ(triangles.size(), 2u);
  EXPECT_EQ(triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
  Polygon circle;
  for (float angle = 0; angle < 6.28f; angle += 0.0628f) {
    circle.emplace_back(std::cos(angle), std::sin(angle), 1.0f);
  }
  expect_covered(circle);
}

TEST(Triangulate, ConcavePolygonsKeepTheirArea) {
  expect_covered_everywhere(flat({{0, 0}, {4, 0}, {1, 1}, {0, 4}}));                  // arrow head
  expect_covered_everywhere(flat({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}));  // L
  expect_covered_everywhere(
      flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}));  // U
  expect_covered_everywhere(
      flat({{0, 0}, {5, 0}, {5, 3}, {4, 1}, {3, 3}, {2, 1}, {1, 3}}));  // comb
}

TEST(Triangulate, CollinearCornersGiveNoEmptyTriangles) {
  expect_covered_everywhere(flat({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}));
  expect_covered_everywhere(flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}));
  expect_covered_everywhere(flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {0, 3}}));
  // Thirds are not exact in binary, but corners along an axis stay collinear in every projection.
  expect_covered_everywhere(flat({{0, 0}, {1 / 3.0f, 0}, {0.7f, 0}, {1.1f, 0}, {1.1f, 0.1f}}));
}

TEST(Triangulate, RepeatedPointsCostOneEmptyTriangleEach) {
  expect_covered_everywhere(flat({{0, 0}, {0, 0}, {2, 0}, {2, 2}, {0, 2}}), 1);
  expect_covered_everywhere(flat({{0, 0}, {4, 0}, {1, 1}, {1, 1}, {1, 1}, {0, 4}}), 2);
}

TEST(Triangulate, SpikeOutOfAPolygon) {
  expect_covered_everywhere(flat({{0, 0}, {2, 0}, {4, 0}, {2, 0}, {2, 2}, {0, 2}}), 2);
}

// A hole in a polygon of an OBJ file is usually joined to the boundary by a pair of equal edges.
TEST(Triangulate, HoleReachedByABridge) {
  const Polygon ring =
      flat({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}});
  EXPECT_NEAR(areas_of(ring).polygon, 32, 1e-9);
  expect_covered_everywhere(ring);
}

TEST(Triangulate, TwoHoles) {
  expect_covered_everywhere(flat({{0, 0},
                                  {9, 0},
                                  {9, 5},
                                  {0, 5},
                                  {0, 0},
                                  {1, 1},
                                  {1, 3},
                                  {3, 3},
                                  {3, 1},
                                  {5, 1},
                                  {5, 3},
                                  {7, 3},
                                  {7, 1},
                                  {5, 1},
                                  {3, 1},
                                  {1, 1}}));
}

TEST(Triangulate, PolygonThatTouchesItselfInAPoint) {
  expect_covered_everywhere(flat({{0, 0}, {2, 1}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}), 2);
}

// The corner between two close petals seems convex, with both petals in its ear.
TEST(Triangulate, PetalsThatMeetInAPoint) {
  expect_covered_everywhere(flat({{0, 0}, {9, 0}, {9, 3}, {0, 0}, {3, 9}, {0, 9}}), 2);
  expect_covered_everywhere(
      flat({{0, 0}, {9, 0}, {11, 2}, {9, 3}, {0, 0}, {3, 9}, {1, 10}, {0, 9}}), 2);
}

TEST(Triangulate, Spiral) {
  Polygon spiral;
  const int turns = 200;
  for (int i = 0; i <= turns; ++i) {
    const float angle = 0.1f * static_cast<float>(i);
    spiral.emplace_back((1 + angle) * std::cos(angle), (1 + angle) * std::sin(angle), 0.0f);
  }
  for (int i = turns; i >= 0; --i) {
    const float angle = 0.1f * static_cast<float>(i);
    spiral.emplace_back((0.5f + angle) * std::cos(angle), (0.5f + angle) * std::sin(angle), 0.0f);
  }
  EXPECT_FALSE(is_convex(spiral));
  expect_covered(spiral);
  std::reverse(spiral.begin(), spiral.end());
  expect_covered(spiral);
}

TEST(Triangulate, RandomStarsInRandomPlanes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int round = 0; round < 500; ++round) {
    const int n = 4 + round % 40;
    const Vec3 u = normalize(Vec3(uniform(random), uniform(random), uniform(random)) - 0.5f);
    const Vec3 v = normalize(cross(u, Vec3(uniform(random), uniform(random), 2.0f)));
    const Vec3 centre = 10.0f * Vec3(uniform(random), uniform(random), uniform(random));
    Polygon star;
    for (int i = 0; i < n; ++i) {
      const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(n);
      const float radius = 0.1f + uniform(random);
      star.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    SCOPED_TRACE("round " + std::to_string(round));
    expect_covered(star, 0, 1e-4);
  }
}

TEST(Triangulate, ScaleDoesNotMatter) {
  for (const float scale : {1e-18f, 1e-6f, 1e6f, 1e18f}) {
    Polygon arrow = flat({{0, 0}, {4, 0}, {1, 1}, {0, 4}});
    for (Vec3& p : arrow) p *= scale;
    expect_covered(arrow);
  }
}

TEST(Triangulate, PolygonsThatAreNotSimpleAreCutTooWithTheSameSignedArea) {
  const Polygon pentagram = flat({{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}});
  EXPECT_EQ(triangulate(pentagram).size(), 3u);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (int n = 4; n < 60; ++n) {
    Polygon tangle;
    for (int i = 0; i < n; ++i) tangle.emplace_back(uniform(random), uniform(random), 0.5f);
    ASSERT_EQ(triangulate(tangle).size(), static_cast<std::size_t>(n - 2));
    const Areas areas = areas_of(tangle);
    EXPECT_NEAR(areas.sum, areas.polygon, 1e-5);
  }
}

TEST(Triangulate, PolygonsWithoutAreaStillGiveTheirNumberOfTriangles) {
  EXPECT_EQ(triangulate(flat({{0, 0}, {1, 1}, {2, 2}, {3, 3}})).size(), 2u);
  EXPECT_EQ(triangulate(Polygon(7, Vec3(1.0f))).size(), 5u);
}

TEST(Triangulate, HugeTangleEndsSoon) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Polygon tangle;
  for (int i = 0; i < 5000; ++i) tangle.emplace_back(uniform(random), uniform(random), 0.0f);
  EXPECT_EQ(triangulate(tangle).size(), 4998u);
}

TEST(NewellNormal, IsTwiceTheAreaAndFollowsTheOrientation) {
  const Polygon square = flat({{0, 0}, {3, 0}, {3, 3}, {0, 3}});
  EXPECT_EQ(newell_normal(square), DVec3(0, 0, 18));
  EXPECT_EQ(newell_normal(Polygon(square.rbegin(), square.rend())), DVec3(0, 0, -18));
  EXPECT_EQ(newell_normal({}), DVec3(0.0));
}

TEST(NewellNormal, KeepsPrecisionFarFromTheOrigin) {
  Polygon square = flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (Vec3& p : square) p += Vec3(1e6f, -2e6f, 3e6f);
  EXPECT_EQ(newell_normal(square), DVec3(0, 0, 2));
}

// A plain (or fused) cross product would not be exactly 0 when two corners coincide.
TEST(NewellNormal, IsExactlyZeroWithoutArea) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> exponent(-20, 20);
  const auto coordinate = [&] { return std::exp2(exponent(random)); };
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a(coordinate(), coordinate(), coordinate());
    const Vec3 b(coordinate(), coordinate(), coordinate());
    EXPECT_EQ(newell_normal(Polygon{a, b, b}), DVec3(0.0));
    EXPECT_EQ(newell_normal(Polygon{a, b, a}), DVec3(0.0));
    EXPECT_EQ(newell_normal(Polygon{a, a, b}), DVec3(0.0));
  }
}

TEST(IsConvex, TellsConvexFromConcave) {
  EXPECT_TRUE(is_convex(flat({{0, 0}, {1, 0}, {0, 1}})));
  EXPECT_TRUE(is_convex(flat({{0, 0}, {0, 1}, {1, 0}})));  // clockwise, that is seen from behind
  EXPECT_TRUE(is_convex(flat({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})));
  EXPECT_TRUE(is_convex(flat({{0, 0}, {2, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}})));
  EXPECT_FALSE(is_convex(flat({{0, 0}, {4, 0}, {1, 1}, {0, 4}})));
  EXPECT_FALSE(is_convex(flat({{0, 0}, {2, 0}, {3, 0}, {2, 0}, {2, 2}, {0, 2}})));  // a spike
  EXPECT_FALSE(is_convex(flat({{0, 0}, {1, 0}, {2, 0}})));                          // zero area
}

TEST(IsConvex, WindingTwiceIsNotConvex) {
  Polygon pentagram;
  for (const int i : {0, 2, 4, 1, 3}) {
    const float angle = 1.2566371f * static_cast<float>(i);
    pentagram.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
  }
  EXPECT_FALSE(is_convex(pentagram));
  const Polygon square = flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  Polygon twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  EXPECT_FALSE(is_convex(twice));
}

}  // namespace
}  // namespace raytracing
