#include "raytracing/sampling/spherical.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "raytracing/math/numeric.h"
#include "raytracing/math/vec.h"
#include "support/planar_polygon.h"

namespace raytracing {
namespace {

constexpr float kExtremes[] = {0.0f, 0x1p-24f, 0.5f, 1 - 0x1p-23f, kOneMinus};

std::vector<Vec3> corners_of(const Rectangle& r) {
  const Vec3 x = r.width * r.x, y = r.height * r.y;
  return {r.corner, r.corner + x, r.corner + x + y, r.corner + y};
}

Rectangle rectangle_at(const Vec3& corner, const Vec3& normal, float width, float height) {
  const Frame frame = Frame::around(normal);
  return {corner, frame.x, frame.y, width, height};
}

// Returns the closed form, the signed sum over the corners of atan(x y / (z r)), in long double.
double reference(const Rectangle& r, const Vec3& from) {
  const LVec3 d = LVec3(r.corner) - LVec3(from);
  const long double x0 = dot(d, LVec3(r.x)), y0 = dot(d, LVec3(r.y));
  const long double z = std::abs(dot(d, cross(LVec3(r.x), LVec3(r.y))));
  const auto corner = [&](long double x, long double y) {
    return std::atan2(x * y, z * std::sqrt(x * x + y * y + z * z));
  };
  const long double x1 = x0 + r.width, y1 = y0 + r.height;
  return static_cast<double>(corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0));
}

// A rectangle with edges of 0.01 .. 100 and a point at a height of 1e-3 .. 1e3 sizes above its
// plane, over the rectangle or up to one size beside it.
struct Configuration {
  Rectangle rectangle;
  Vec3 from;
};
Configuration random_configuration(TestRandom& random, const Vec3& normal, bool at_origin) {
  const float width = std::pow(10.0f, random.between(-2, 2));
  const float height = width * std::pow(10.0f, random.between(-1, 1));
  const Vec3 corner = at_origin ? Vec3(0, 0, 0) : random.in_cube(width);
  const Rectangle r = rectangle_at(corner, normal, width, height);
  const float size = std::max(width, height);
  const float above = size * std::pow(10.0f, random.between(-3, 3));
  const float x = random.between(-1, 2) * width, y = random.between(-1, 2) * height;
  return {r, corner + x * r.x + y * r.y + above * normal};
}

// The documented error holds. Float arithmetic had an error of 1e-6, which biased the estimates at
// points near the plane of a rectangle.
TEST(SphericalRectangle, SolidAngleIsTheClosedForm) {
  TestRandom random(1);
  double largest = 0, relative = 0;
  for (int i = 0; i < 400000; ++i) {
    const bool exact = i % 2 == 0;
    const Vec3 normal = exact ? Vec3(0, 0, 1) : random.direction();
    const auto [r, from] = random_configuration(random, normal, exact);
    const double expected = reference(r, from);
    const double error = std::abs(SphericalRectangle(r, from).solid_angle() - expected);
    ASSERT_LE(error, 1e-9) << i;
    largest = std::max(largest, error);
    if (expected > 3e-3) relative = std::max(relative, error / expected);
  }
  EXPECT_LE(relative, 1e-7);
  std::printf("largest error %.2g; relative %.2g\n", largest, relative);
}

TEST(SphericalTriangle, SolidAngleIsTheClosedForm) {
  TestRandom random(2);
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    const Vec3 a = random.in_cube(1), b = random.in_cube(1), c = random.in_cube(1);
    const Vec3 n = normalize(cross(b - a, c - a));
    const Vec3 from = a + random.between(-1, 1) * (b - a) + random.between(-1, 1) * (c - a) +
                      std::pow(10.0f, random.between(-3, 3)) * n;
    const double exact = reference_solid_angle(LVec3(a) - LVec3(from), LVec3(b) - LVec3(from),
                                               LVec3(c) - LVec3(from));
    const double error = SphericalTriangle({a, b, c}, from).solid_angle() - exact;
    ASSERT_TRUE(std::isfinite(error));
    worst = std::max(worst, std::abs(error) / exact);
  }
  EXPECT_LE(worst, 1e-8);
  std::printf("largest relative error %.2g\n", worst);
}

// Points relative to a rectangle of 2 by 1 with its corner at the origin and the normal z: above
// the middle, near, nearer, beside an edge, beside a corner, far, at a grazing angle, above a
// corner.
const Vec3 kPlaces[] = {{1, 0.5f, 1},        {1, 0.5f, 0.2f},    {1.3f, 0.4f, 0.05f},
                        {-0.5f, 0.5f, 0.3f}, {2.2f, 1.3f, 0.4f}, {3, -5, 7},
                        {4, 0.6f, 0.3f},     {0, 0, 0.5f}};

TEST(SphericalRectangle, SamplesAreUniformInSolidAngle) {
  const double level = sidak_level(kFamilyLevel, std::size(kPlaces));
  TestRandom random(3);
  for (const Vec3& place : kPlaces) {
    const Rectangle r = rectangle_at({10, -3, 4}, normalize(Vec3(1, 2, -3)), 2, 1);
    const Vec3 from = r.corner + place.x * r.x + place.y * r.y + place.z * cross(r.x, r.y);
    const SphericalRectangle seen(r, from);
    const std::vector<Vec3> corners = corners_of(r);
    const PolygonCells cells(corners, 8);
    std::vector<double> counts(cells.size());
    for (int i = 0; i < 100000; ++i) {
      const Vec3 q = seen.sample(random.unit2());
      ASSERT_LE(cells.distance_outside(q), 3e-6) << q.x << " " << q.y << " " << q.z;
      ++counts[cells.cell(q)];
    }
    EXPECT_GT(chi_square_test(counts, cells.solid_angles(from)).p_value, level)
        << place.x << " " << place.y << " " << place.z;
  }
}

// From close by, the rectangle covers nearly a hemisphere: azimuth and cosine of directions not too
// close to the horizon are uniform. Samples lie on the rectangle.
TEST(SphericalRectangle, SamplesFromCloseByAreUniformInSolidAngle) {
  constexpr std::size_t kBins = 8;
  constexpr double kLowest = 0.05;
  const float heights[] = {0.01f, 1e-3f, 1e-4f, 1e-5f};
  TestRandom random(7);
  const Rectangle r = {{-0.7f, -0.6f, 0}, {1, 0, 0}, {0, 1, 0}, 2, 1};
  const PolygonCells cells(corners_of(r), 1);
  for (const float height : heights) {
    const SphericalRectangle seen(r, {0, 0, height});
    std::vector<double> counts(kBins * kBins);
    for (int i = 0; i < 100000; ++i) {
      const Vec3 q = seen.sample(random.unit2());
      ASSERT_LE(cells.distance_outside(q), 1e-7);
      const double cosine = height / std::hypot(double{q.x}, double{q.y}, double{height});
      if (cosine < kLowest) continue;
      const double turn = std::atan2(double{q.y}, double{q.x}) / (2 * std::numbers::pi) + 0.5;
      ++counts[kBins * cell_of(turn, kBins) + cell_of((cosine - kLowest) / (1 - kLowest), kBins)];
    }
    EXPECT_GT(chi_square_test(counts, std::vector<double>(counts.size(), 1.0)).p_value,
              sidak_level(kFamilyLevel, std::size(heights)))
        << height;
  }
}

TEST(SphericalTriangle, SamplesAreUniformInSolidAngle) {
  const double level = sidak_level(kFamilyLevel, std::size(kPlaces));
  TestRandom random(4);
  const std::array<Vec3, 3> corners = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0.7f, 1.5f, 0)};
  for (const Vec3& from : kPlaces) {
    const SphericalTriangle seen(corners, from);
    const PolygonCells cells(corners, 8);
    std::vector<double> counts(cells.size());
    for (int i = 0; i < 100000; ++i) {
      const auto q = seen.sample(random.unit2());
      ASSERT_TRUE(q);
      ASSERT_LE(cells.distance_outside(*q), 1e-6) << q->x << " " << q->y << " " << q->z;
      ++counts[cells.cell(*q)];
    }
    EXPECT_GT(chi_square_test(counts, cells.solid_angles(from)).p_value, level)
        << from.x << " " << from.y << " " << from.z;
  }
}

TEST(SphericalRectangle, ExtremesStayOnTheRectangle) {
  TestRandom random(5);
  for (int i = 0; i < 20000; ++i) {
    const Configuration c = random_configuration(random, random.direction(), false);
    const Rectangle& r = c.rectangle;
    const Vec3 from = c.from;
    const SphericalRectangle seen(r, from);
    const std::vector<Vec3> corners = corners_of(r);
    const float size = max_component(absolute(from)) + max_component(absolute(corners[2]));
    for (float x : kExtremes)
      for (float y : kExtremes) {
        const double outside = PolygonCells(corners, 1).distance_outside(seen.sample({x, y}));
        ASSERT_LE(outside, 1e-6f * size) << i << " " << x << " " << y;
      }
  }
}

// This holds for points close to the plane too, for all solid angles that lights sample.
TEST(SphericalTriangle, ExtremesStayOnTheTriangle) {
  TestRandom random(6);
  for (int i = 0; i < 20000; ++i) {
    const std::array<Vec3, 3> c = {random.in_cube(1), random.in_cube(1), random.in_cube(1)};
    const float height = std::pow(10.0f, random.between(-6, 1));
    const Vec3 from = c[0] + random.between(-1, 1) * (c[1] - c[0]) +
                      random.between(-1, 1) * (c[2] - c[0]) +
                      height * normalize(cross(c[1] - c[0], c[2] - c[0]));
    const PolygonCells cells(c, 1);
    const SphericalTriangle seen(c, from);
    if (seen.solid_angle() < 3e-3 || seen.solid_angle() > 6.2831) continue;
    for (float x : kExtremes)
      for (float y : kExtremes) {
        const auto q = seen.sample({x, y});
        ASSERT_LE(q ? cells.distance_outside(*q) : 0.0, 1e-6) << i << " " << x << " " << y;
      }
  }
}

TEST(SphericalRectangle, InItsPlaneIsFiniteOrFull) {
  const Rectangle r = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 1};
  for (float z : {0.0f, -0.0f, 1e-30f, 1e-10f})
    for (float x : {-1.0f, 0.0f, 1.0f, 2.0f, 3.0f})
      for (float y : {-1.0f, 0.0f, 0.5f, 1.0f, 2.0f}) {
        const double solid_angle = SphericalRectangle(r, {x, y, z}).solid_angle();
        EXPECT_FALSE(std::isnan(solid_angle)) << x << " " << y << " " << z;
      }
}

TEST(SphericalTriangle, DegenerateGivesNothingOrFinitePoints) {
  const std::vector<std::array<Vec3, 3>> triangles = {
      {Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},    // two corners the same
      {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 2, 0)},    // a line, seen from outside
      {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, -1, 0)},  // around the observer, in its plane
      {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0)},   // observer on an edge
      {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},    // observer at a corner
      {Vec3(1, 0, 1e-20f), Vec3(0, 1, 1e-20f), Vec3(1, 1, 1e-20f)}};
  for (const auto& triangle : triangles) {
    const SphericalTriangle seen(triangle, {0, 0, 0});
    for (float x : kExtremes)
      for (float y : kExtremes) {
        const auto q = seen.sample({x, y});
        EXPECT_TRUE(!q || length(*q) < 2.3f) << (&triangle - triangles.data());
      }
  }
}

}  // namespace
}  // namespace raytracing
