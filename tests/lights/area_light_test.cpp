#include "raytracing/lights/area_light.h"

#include <gtest/gtest.h>

#include "raytracing/math/numeric.h"
#include "raytracing/math/vec.h"
#include "support/planar_polygon.h"

namespace raytracing {
namespace {

constexpr float kExtremes[] = {0.0f, 0x1p-24f, 0.5f, 1 - 0x1p-23f, kOneMinus};
constexpr std::size_t kGrid = 7;  // cells across a light
constexpr int kSamples = 50000;

struct Shape {
  const char* name;
  AreaLight light;
};

// Makes a light from 2D corners in a rotated and translated plane.
AreaLight light_of(std::vector<Vec2> corners) {
  const Frame frame = Frame::around(normalize(Vec3(1, -2, 3)));
  std::vector<Vec3> placed;
  for (const Vec2& c : corners) placed.push_back(Vec3(5, 6, -7) + c.x * frame.x + c.y * frame.y);
  return AreaLight(placed, Rgb(1, 2, 3));
}

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = {
      {"triangle", light_of({{0, 0}, {2, 0}, {0.5f, 1.5f}})},
      {"rectangle", light_of({{0, 0}, {2, 0}, {2, 1}, {0, 1}})},
      {"parallelogram", light_of({{0, 0}, {2, 0}, {2.7f, 1}, {0.7f, 1}})},
      {"quad", light_of({{0, 0}, {2, 0}, {1.6f, 1.9f}, {0.2f, 0.8f}})},
      {"pentagon", light_of({{0, 0}, {1.5f, -0.4f}, {2.2f, 0.5f}, {1.2f, 1.7f}, {-0.3f, 1.1f}})},
      {"collinear corner", light_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}})},
  };
  return all;
}

// Returns the point with these coordinates along the first edge, across it, and along the normal.
Vec3 place(const AreaLight& light, float x, float y, float height) {
  const Vec3 along = normalize(light.corners[1] - light.corners[0]);
  return light.corners[0] + x * along + y * cross(light.normal, along) + height * light.normal;
}

// Points above the light, near it, beside it, far from it (with a small but usable solid angle),
// and at a grazing angle.
std::vector<Vec3> places(const AreaLight& light) {
  return {place(light, 1, 0.5f, 1), place(light, 0.9f, 0.4f, 0.15f), place(light, -1, 2, 0.5f),
          place(light, 4, -6, 9), place(light, 3, 0.4f, 0.2f)};
}

double p_value(const AreaLight& light, std::span<const double> expected, const auto& sample) {
  TestRandom random(1);
  const PolygonCells cells(light.corners, kGrid);
  std::vector<double> counts(cells.size());
  for (int i = 0; i < kSamples; ++i) {
    const Vec3 q = sample(random.unit2());
    EXPECT_LE(cells.distance_outside(q), 1e-5);
    ++counts[cells.cell(q)];
  }
  return chi_square_test(counts, expected).p_value;
}

TEST(AreaLight, KnowsItsShape) {
  for (const auto& [name, light] : shapes()) {
    const PolygonCells cells(light.corners, kGrid);
    const std::vector<double> areas = cells.areas();
    double area = 0;
    for (double a : areas) area += a;
    EXPECT_NEAR(light.area, area, 2e-6) << name;
    EXPECT_NEAR(light.power(), kPi * area * 2, 2e-5) << name;
    EXPECT_NEAR(dot(light.normal, normalize(Vec3(1, -2, 3))), 1, 1e-6) << name;
    EXPECT_EQ(light.rectangle.has_value(), std::string(name) == "rectangle");
  }
  EXPECT_TRUE(shapes()[1].light.parallelogram && shapes()[2].light.parallelogram);
  EXPECT_FALSE(shapes()[3].light.parallelogram);
}

TEST(AreaLight, SampleAreaIsUniform) {
  const double level = sidak_level(kFamilyLevel, static_cast<double>(shapes().size()));
  for (const auto& [name, light] : shapes()) {
    const auto sample = [&, &emitter = light](const Vec2& u) { return sample_area(emitter, u); };
    const std::vector<double> expected = PolygonCells(light.corners, kGrid).areas();
    EXPECT_GT(p_value(light, expected, sample), level) << name;
  }
}

TEST(AreaLight, SampleSolidAngleIsUniform) {
  const double level = sidak_level(kFamilyLevel, 5.0 * static_cast<double>(shapes().size()));
  for (const auto& [name, light] : shapes())
    for (const Vec3& from : places(light)) {
      const auto sample = [&, &emitter = light](const Vec2& u) {
        const auto s = sample_solid_angle(emitter, from, u);
        EXPECT_TRUE(s);
        EXPECT_EQ(s->pdf_w, solid_angle_pdf_w(emitter, from, s->point));
        return s->point;
      };
      const std::vector<double> expected = PolygonCells(light.corners, kGrid).solid_angles(from);
      EXPECT_GT(p_value(light, expected, sample), level) << name;
    }
}

// Each density is 1 / solid angle, not only their mean.
TEST(AreaLight, SolidAngleDensityIsOneOverTheSolidAngle) {
  for (const auto& [name, light] : shapes())
    for (const Vec3& from : places(light)) {
      const double exact = reference_solid_angle<Vec3>(light.corners, from);
      const float pdf_w = solid_angle_pdf_w(light, from, light.corners[0]);
      EXPECT_NEAR(pdf_w * exact, 1, 2e-5) << name;
    }
}

// The mean of 1 / density is the solid angle for both sampling methods from all points, including
// those where solid-angle sampling falls back to area sampling (far, and very near).
TEST(AreaLight, MeanInverseDensityIsTheSolidAngle) {
  const double level = sidak_level(kFamilyLevel, 9.0 * static_cast<double>(shapes().size()));
  for (const auto& [name, light] : shapes()) {
    std::vector<Vec3> from = places(light);
    from.push_back(place(light, 60, 30, 90));
    from.push_back(place(light, 40, 30, 2));
    for (const Vec3& p : from) {
      TestRandom random(2);
      RunningStats by_area, by_angle;
      for (int i = 0; i < 20000; ++i) {
        by_area.add(1 / area_pdf_w(light, p, sample_area(light, random.unit2())));
        by_angle.add(1 / sample_solid_angle(light, p, random.unit2())->pdf_w);
      }
      const double exact = reference_solid_angle<Vec3>(light.corners, p);
      EXPECT_GT(mean_p_value(by_area, exact, 1e-5 * exact), level) << name;
      EXPECT_GT(mean_p_value(by_angle, exact, 3e-5 * exact), level) << name;
    }
  }
}

TEST(AreaLight, TinyAndHugeSolidAnglesAreSampledByArea) {
  for (const auto& [name, light] : shapes())
    for (const Vec3& from : {place(light, 0.9f, 0.4f, 100), place(light, 0.9f, 0.4f, 3e-6f)})
      for (float x : kExtremes)
        for (float y : kExtremes) {
          const auto s = sample_solid_angle(light, from, {x, y});
          ASSERT_TRUE(s) << name;
          EXPECT_EQ(s->point, sample_area(light, {x, y})) << name;
          EXPECT_EQ(s->pdf_w, area_pdf_w(light, from, s->point)) << name;
          EXPECT_EQ(s->pdf_w, solid_angle_pdf_w(light, from, s->point)) << name;
        }
}

TEST(AreaLight, NothingFromBehind) {
  for (const auto& [name, light] : shapes()) {
    const Vec3 behind = place(light, 1, 0.5f, -0.5f);
    EXPECT_FALSE(sample_solid_angle(light, behind, {0.3f, 0.6f})) << name;
    EXPECT_EQ(solid_angle_pdf_w(light, behind, light.corners[0]), 0) << name;
    EXPECT_EQ(area_pdf_w(light, behind, sample_area(light, {0.3f, 0.6f})), 0) << name;
  }
}

// Densities are never NaN, not even for points in the plane of the light up to rounding. Samples
// lie on the light, unless the point touches it.
TEST(AreaLight, ExtremesGiveFinitePointsAndDensities) {
  for (const auto& [name, light] : shapes()) {
    const PolygonCells cells(light.corners, 1);
    std::vector<Vec3> from = places(light);
    for (float height : {0.0f, 1e-6f, 1e-3f, 30.0f})
      for (float x : {-3.0f, 0.0f, 0.5f, 2.0f})
        for (float y : {-2.0f, 0.0f, 0.5f, 1.0f}) from.push_back(place(light, x, y, height));
    for (const Vec3& p : from)
      for (float x : kExtremes)
        for (float y : kExtremes) {
          EXPECT_LE(cells.distance_outside(sample_area(light, {x, y})), 3e-6) << name;
          const auto s = sample_solid_angle(light, p, {x, y});
          if (!s) continue;
          EXPECT_FALSE(std::isnan(s->pdf_w)) << name;
          const bool touches = dot(p - light.corners[0], light.normal) < 1e-4f;
          EXPECT_LE(cells.distance_outside(s->point), touches ? 1e-2 : 3e-5)
              << name << " u " << x << " " << y << " from " << p.x << " " << p.y << " " << p.z
              << " pdf_w " << s->pdf_w;
        }
  }
}

}  // namespace
}  // namespace raytracing
