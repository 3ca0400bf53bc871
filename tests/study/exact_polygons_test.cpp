// The truth's polygons: closed forms and brute force.

#include "raytracing/study/stress/exact_polygons.h"

#include <gtest/gtest.h>

#include "support/statistics.h"

namespace raytracing {
namespace {

LPolygon rectangle(long double x0, long double x1, long double y0, long double y1,
                   long double z = 1) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

long double area(const std::vector<LPolygon>& pieces) {
  long double sum = 0;
  for (const LPolygon& piece : pieces) sum += length(area_vector(piece)) / 2;
  return sum;
}

bool contains(const LPolygon& polygon, const LVec3& q) {
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (dot(q - polygon[i], inward(polygon, i)) < 0) return false;
  return true;
}

constexpr LVec3 kUp{0.0L, 0.0L, 1.0L};

// Form factor of a rectangle a x b parallel to a small area under one of its corners, at the
// distance 1 (Howell's catalogue, B-3), times pi.
TEST(ExactPolygons, LambertOfAParallelRectangle) {
  for (const long double a : {0.01L, 1.0L, 30.0L})
    for (const long double b : {0.2L, 5.0L}) {
      const long double ra = std::sqrt(1 + a * a), rb = std::sqrt(1 + b * b);
      const long double expected = (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb)) / 2;
      EXPECT_NEAR(static_cast<double>(lambert(rectangle(0, a, 0, b), LVec3(0.0L), kUp) / expected),
                  1, 1e-15);
    }
}

// And of one at right angles to the area, standing on its plane at the distance 1 (B-4).
TEST(ExactPolygons, LambertOfAStandingRectangle) {
  for (const long double b : {0.01L, 1.0L, 30.0L})
    for (const long double h : {0.2L, 5.0L}) {
      const LPolygon wall{{1, 0, 0}, {1, b, 0}, {1, b, h}, {1, 0, h}};
      const long double r = std::sqrt(1 + h * h);
      const long double expected = (std::atan(b) - std::atan(b / r) / r) / 2;
      EXPECT_NEAR(static_cast<double>(lambert(wall, LVec3(0.0L), kUp) / expected), 1, 1e-15);
    }
}

TEST(ExactPolygons, DifferenceTakesAwayTheCommonPart) {
  const LPolygon whole = rectangle(0, 2, 0, 1);
  EXPECT_NEAR(static_cast<double>(area(difference({whole}, rectangle(1, 3, -1, 3)))), 1, 1e-15);
  EXPECT_NEAR(static_cast<double>(area(difference({whole}, rectangle(0.5L, 1, 0.25L, 0.5L)))),
              1.875, 1e-15);
  EXPECT_EQ(area(difference({whole}, rectangle(-1, 3, -1, 3))), 0);
  EXPECT_EQ(area(difference({whole}, rectangle(2.5L, 3, -1, 3))), 2);
  EXPECT_EQ(area(difference({whole}, {})), 2);
  // A window taken twice takes nothing more; the order of its corners does not matter.
  LPolygon window = rectangle(0.5L, 1.5L, 0.5L, 3);
  const auto once = difference({whole}, window);
  EXPECT_NEAR(static_cast<double>(area(difference(once, window))), 1.5, 1e-15);
  std::reverse(window.begin(), window.end());
  EXPECT_NEAR(static_cast<double>(area(difference({whole}, window))), 1.5, 1e-15);
}

// In a plane that no coordinate of the shadow meets to the last digit, from wherever it is thrown.
TEST(ExactPolygons, ShadowsOnAPlaneAcrossAnAxis) {
  TestRandom random(4);
  const LPolygon light = rectangle(-1, 1, -1, 1, 0.1f);
  const LPolygon occluder = rectangle(-4, 0, -4, 4, 0.05f);
  for (int i = 0; i < 1000; ++i) {
    const LVec3 p(0.01L, 0, random.between(-1e-6f, 1e-6f));
    const LPolygon occluders[]{occluder};
    const long double edge = 0.01L * (1 - (0.1f - p.z) / (0.05f - p.z));
    EXPECT_NEAR(static_cast<double>(area(visible_pieces(light, occluders, p))),
                static_cast<double>(2 * (1 - edge)), 1e-12)
        << i;
  }
}

// Overlapping occluders at several heights, some of them partly behind the point or the light,
// against rays: each point of a grid on the light is in as many pieces as it is seen, one or none.
TEST(ExactPolygons, VisiblePiecesAgreeWithRays) {
  TestRandom random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const LPolygon light{{-1, -1, 1}, {1, -1, 1.4L}, {1, 1, 1.4L}, {-1, 1, 1}};
    const LVec3 p(0.1L, -0.2L, 0);
    std::vector<LPolygon> occluders;
    for (int i = 0; i < 5; ++i) {
      const LVec3 center(random.in_cube(0.6f) + Vec3(0.0f, 0.0f, 0.6f));
      const LVec3 x(random.in_cube(0.7f)), y(random.in_cube(0.7f));
      occluders.push_back({center, center + x, center + y});
    }
    const std::vector<LPolygon> pieces = visible_pieces(light, occluders, p);
    const auto hidden = [&](const LVec3& q) {
      for (const LPolygon& o : occluders) {
        const LVec3 n = area_vector(o);
        const long double t = dot(o[0] - p, n) / dot(q - p, n);
        if (t > 0 && t < 1 && contains(o, p + t * (q - p))) return true;
      }
      return false;
    };
    for (int i = 0; i < 400; ++i) {
      const LVec3 q = light[0] + static_cast<long double>(random.unit()) * (light[1] - light[0]) +
                      static_cast<long double>(random.unit()) * (light[3] - light[0]);
      int found = 0;
      for (const LPolygon& piece : pieces) found += contains(piece, q);
      EXPECT_EQ(found, hidden(q) ? 0 : 1) << trial << " " << i;
    }
  }
}

}  // namespace
}  // namespace raytracing
