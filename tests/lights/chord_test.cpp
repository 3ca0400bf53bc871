#include "raytracing/lights/chord.h"

#include <gtest/gtest.h>

#include "raytracing/lights/area_light.h"
#include "raytracing/math/vec.h"
#include "support/planar_polygon.h"

namespace raytracing {
namespace {

std::vector<Vec3> polygon(std::vector<Vec2> corners) {
  const Frame frame = Frame::around(normalize(Vec3(3, 1, -2)));
  std::vector<Vec3> placed;
  for (const Vec2& c : corners) placed.push_back(Vec3(-3, 4, 9) + c.x * frame.x + c.y * frame.y);
  return placed;
}

std::vector<std::vector<Vec3>> polygons() {
  return {polygon({{0, 0}, {2, 0}, {0.5f, 1.5f}}), polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}}),
          polygon({{0, 0}, {2, 0}, {1.6f, 1.9f}, {0.2f, 0.8f}}),
          polygon({{0, 0}, {1.5f, -0.4f}, {2.2f, 0.5f}, {1.2f, 1.7f}, {-0.3f, 1.1f}})};
}

// Returns the distance of a point from the nearest edge.
double distance_to_boundary(const std::vector<Vec3>& corners, const Vec3& p) {
  double best = INFINITY;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const DVec3 a(corners[i]), e = DVec3(corners[(i + 1) % corners.size()]) - a;
    const double t = std::clamp(dot(DVec3(p) - a, e) / dot(e, e), 0.0, 1.0);
    best = std::min(best, length(DVec3(p) - (a + t * e)));
  }
  return best;
}

// The chords of a polygon in a direction of its plane; `turn` in [0,1) is its angle over 2 pi.
struct Setting {
  AreaLight light;
  ChordSet chords;
  Setting(const std::vector<Vec3>& corners, float turn) : light(corners, Rgb(1.0f)) {
    const Frame frame = Frame::around(light.normal);
    const float phi = 2 * std::numbers::pi_v<float> * turn;
    chords = ChordSet(corners, light.normal, std::cos(phi) * frame.x + std::sin(phi) * frame.y);
  }
};

// The length of chords is linear between corners, so that the midpoint rule with n steps has an
// error of a few 1/n^2.
double integral_of_lengths(const ChordSet& chords, int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const float u = chords.extent() * (static_cast<float>(i) + 0.5f) / static_cast<float>(n);
    const auto chord = chords.at(u);
    if (chord) sum += chord->length;
  }
  return sum * chords.extent() / n;
}

TEST(Chords, LengthsIntegrateToTheArea) {
  for (const std::vector<Vec3>& corners : polygons()) {
    for (float turn : {0.0f, 0.1f, 0.33f, 0.71f}) {
      const Setting setting(corners, turn);
      EXPECT_NEAR(integral_of_lengths(setting.chords, 2000), setting.light.area, 1e-3);
    }
    const AreaLight light(corners, Rgb(1.0f));
    EXPECT_NEAR(integral_of_lengths(light.chords[0], 2000), light.area, 1e-3);
  }
}

TEST(Chords, EndsLieOnTheBoundary) {
  TestRandom random(1);
  for (const std::vector<Vec3>& corners : polygons())
    for (int i = 0; i < 2000; ++i) {
      const Setting setting(corners, random.unit());
      const auto chord = setting.chords.at(random.unit() * setting.chords.extent());
      ASSERT_TRUE(chord);
      EXPECT_NEAR(length(chord->direction), 1, 1e-6);
      EXPECT_GT(chord->length, 0);
      EXPECT_LE(distance_to_boundary(corners, chord->at(0)), 5e-6);
      EXPECT_LE(distance_to_boundary(corners, chord->at(1)), 5e-6);
    }
}

// Uniform points of chords with the density length / area are uniform on the light. Here uniform
// chords are weighted: the mean of length / area * extent over the points of a cell is its share.
TEST(Chords, WeightedPointsCoverTheLightUniformly) {
  const double tests = 4.0 * 25;
  for (const std::vector<Vec3>& corners : polygons()) {
    const Setting setting(corners, 0.13f);
    const PolygonCells cells(corners, 5);
    const std::vector<double> areas = cells.areas();
    std::vector<RunningStats> shares(cells.size());
    TestRandom random(2);
    for (int i = 0; i < 40000; ++i) {
      const auto chord = setting.chords.at(random.unit() * setting.chords.extent());
      const std::size_t cell = chord ? cells.cell(chord->at(random.unit())) : cells.size();
      for (std::size_t k = 0; k < shares.size(); ++k)
        shares[k].add(k == cell ? chord->length * setting.chords.extent() : 0.0);
    }
    for (std::size_t k = 0; k < shares.size(); ++k) {
      if (areas[k] * 40000 < 20 * setting.light.area)
        continue;  // too few points for a normal distribution of the mean
      EXPECT_GT(mean_p_value(shares[k], areas[k]), sidak_level(kFamilyLevel, tests)) << k;
    }
  }
}

TEST(Chords, EndsOfTheExtentAreInsideOrNothing) {
  for (const std::vector<Vec3>& corners : polygons())
    for (float turn : {0.0f, 0.25f, 0.4f, 0.9f}) {
      const Setting setting(corners, turn);
      const float extent = setting.chords.extent();
      for (float u : {0.0f, std::nextafter(0.0f, 1.0f), extent * 0x1p-24f, extent * (1 - 0x1p-24f),
                      std::nextafter(extent, 0.0f), extent, std::nextafter(extent, 2 * extent)}) {
        const auto chord = setting.chords.at(u);
        if (!chord) continue;
        EXPECT_TRUE(std::isfinite(chord->length));
        EXPECT_LE(distance_to_boundary(corners, chord->at(0)), 5e-6);
        EXPECT_LE(distance_to_boundary(corners, chord->at(1)), 5e-6);
      }
    }
}

}  // namespace
}  // namespace raytracing
