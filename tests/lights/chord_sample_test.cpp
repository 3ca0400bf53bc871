#include <gtest/gtest.h>

#include "raytracing/lights/area_light.h"
#include "raytracing/lights/chord.h"
#include "raytracing/math/numeric.h"
#include "support/planar_polygon.h"

namespace raytracing {
namespace {

const std::vector<Vec3> kRectangle{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(0, 1, 0)};
const std::vector<Vec3> kTriangle{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0.5f, 1.5f, 0)};
const std::vector<Vec3> kPentagon{Vec3(0, 0, 0), Vec3(1.5f, -0.4f, 0), Vec3(2.2f, 0.5f, 0),
                                  Vec3(1.2f, 1.7f, 0), Vec3(-0.3f, 1.1f, 0)};
const Vec3 kNear(0.7f, 0.4f, 0.3f), kBeside(4, -2, 1), kFar(30, 20, 90);

// The mean over u of length / pdf_u is the area, by the midpoint rule.
TEST(WholeChords, DensityIntegratesToTheArea) {
  for (const auto& corners : {kRectangle, kTriangle, kPentagon}) {
    const AreaLight light(corners, Rgb(1.0f));
    for (const Vec3& from : {kNear, kBeside, kFar})
      for (int direction : {0, 1}) {
        const int n = 20000;
        double sum = 0;
        for (int i = 0; i < n; ++i) {
          const float u = (static_cast<float>(i) + 0.5f) / n;
          const auto whole = sample_whole_chord(light, from, direction, u);
          ASSERT_TRUE(whole);
          ASSERT_GT(whole->pdf_u, 0);
          sum += whole->chord.length / whole->pdf_u / n;
        }
        EXPECT_NEAR(sum, light.area, 1e-3 * light.area) << corners.size() << " " << direction;
      }
  }
}

// The position x of a whole chord satisfies pdf_u dx/du = 1, from points close to the plane and the
// edges of the light too.
TEST(WholeChords, HaveTheDensityTheyPromise) {
  for (const auto& corners : {kRectangle, kTriangle, kPentagon}) {
    const AreaLight light(corners, Rgb(1.0f));
    for (const Vec3& from : {kNear, kBeside, kFar, Vec3(0.7f, 0.4f, 1e-3f), Vec3(-0.01f, 2, 0.05f),
                             Vec3(2.5f, 0.5f, 0.01f)})
      for (int direction : {0, 1}) {
        const Vec3 along = light.chords[direction].at(0.3f)->direction;
        const Vec3 across = cross(light.normal, along);
        const auto position = [&](float u) {
          const auto sample = sample_whole_chord(light, from, direction, u);
          EXPECT_TRUE(sample);
          EXPECT_GT(dot(sample->chord.direction, along) * dot(sample->chord.direction, along),
                    0.9999f);
          return dot(DVec3(sample->chord.begin), DVec3(across));
        };
        const auto pdf = [&](double u) {
          return sample_whole_chord(light, from, direction, static_cast<float>(u))->pdf_u;
        };
        const double h = 0.005;
        for (double u = 0.025; u < 0.98; u += 0.0475) {
          const double moved =
              std::abs(position(static_cast<float>(u + h)) - position(static_cast<float>(u - h)));
          const double integral = 2 * h * (1 / pdf(u - h) + 4 / pdf(u) + 1 / pdf(u + h)) / 6;
          EXPECT_NEAR(moved / integral, 1, 0.01) << corners.size() << " " << from.z << " " << u;
        }
      }
  }
  const AreaLight light(kRectangle, Rgb(1.0f));
  EXPECT_FALSE(sample_whole_chord(light, Vec3(1, 0.5f, -1), 0, 0.5f));
  EXPECT_FALSE(sample_whole_chord(light, Vec3(5, 0.5f, 0), 1, 0.5f));
}

// Points are uniform in solid angle for near rectangles, and uniform in area for all other lights.
TEST(ChordSample, PointsHaveTheDensityTheyPromise) {
  TestRandom random(1);
  for (const auto& corners : {kRectangle, kTriangle, kPentagon}) {
    const AreaLight light(corners, Rgb(1.0f));
    const PolygonCells cells(corners, 6);
    for (const Vec3& from : {kNear, kBeside, kFar})
      for (int direction : {0, 1}) {
        std::vector<double> counts(cells.size());
        const bool by_angle = sample_chord(light, from, direction, 0.5f)->solid_angle > 0;
        EXPECT_EQ(by_angle, light.rectangle && from != kFar);
        const Interval whole[] = {{0, 1}};
        for (int i = 0; i < 40000; ++i) {
          const auto sample = sample_chord(light, from, direction, random.unit());
          ASSERT_TRUE(sample);
          EXPECT_EQ(sample->share(whole[0]), 1.0f);
          ++counts[cells.cell(sample->chord.at(sample->parameter(whole, random.unit())))];
        }
        const auto expected = by_angle ? cells.solid_angles(from) : cells.areas();
        EXPECT_GT(chi_square_test(counts, expected).p_value, sidak_level(kFamilyLevel, 18))
            << corners.size() << " " << direction;
      }
  }
}

// The density per area is the product of the density along the chord, from the share of a part, and
// the density of the chord. That is du/dx, by central differences of fourth order, for points
// uniform in solid angle, and length / area (see AreaShareOfChords) for points uniform in area.
TEST(ChordSample, PdfIsThatOfThePair) {
  TestRandom random(2);
  for (const auto& corners : {kRectangle, kTriangle, kPentagon}) {
    const AreaLight light(corners, Rgb(1.0f));
    for (int i = 0; i < 3000; ++i) {
      const Vec3 from(random.between(-3, 4), random.between(-3, 4), random.between(0.2f, 4));
      const int direction = i % 2;
      const float u = random.between(0.1f, 0.9f), h = 0.02f;
      const auto sample = sample_chord(light, from, direction, u);
      ASSERT_TRUE(sample);
      const Vec3 across = cross(light.normal, sample->chord.direction);
      const auto difference = [&](float v) {
        const Vec3 ends[] = {sample_chord(light, from, direction, u - v)->chord.begin,
                             sample_chord(light, from, direction, u + v)->chord.begin};
        return std::abs(dot(DVec3(ends[1]) - DVec3(ends[0]), DVec3(across)));
      };
      const double pdf_u = sample->solid_angle > 0
                               ? 12 * h / (8 * difference(h) - difference(2 * h))
                               : sample->chord.length / light.area;
      const float t = random.between(0.05f, 0.95f), step = 0.05f;
      const double along = sample->share({t - step, t + step});
      const Vec3 q = sample->chord.at(t);
      const double expected = integrate(
          [&](double s) {
            const Vec3 x = sample->chord.at(static_cast<float>(s));
            const Vec3 d = from - x;
            const double r2 = dot(d, d);
            const double area_pdf =
                chord_pdf_w(light, from, x) * dot(d, light.normal) / (r2 * std::sqrt(r2));
            return area_pdf * sample->chord.length / pdf_u;
          },
          t - step, t + step);
      const double tolerance = sample->solid_angle > 0 ? 5e-3 : 1e-3;  // x is rounded to float
      ASSERT_NEAR(along, expected, tolerance * expected + 1e-6) << q.x << " " << q.y;
    }
  }
}

TEST(ChordSample, ParametersStayInsideThePartsInOrder) {
  TestRandom random(3);
  for (const auto& corners : {kRectangle, kTriangle}) {
    const AreaLight light(corners, Rgb(1.0f));
    for (int round = 0; round < 2000; ++round) {
      const Vec3& from = round % 3 ? kNear : kBeside;
      const auto sample = sample_chord(light, from, round % 2, random.unit());
      ASSERT_TRUE(sample);
      std::array<float, 6> ends;
      for (float& end : ends) end = random.unit();
      std::sort(ends.begin(), ends.end());
      const Interval parts[] = {{ends[0], ends[1]}, {ends[2], ends[3]}, {ends[4], ends[5]}};
      float last = 0;
      for (float x : {0.0f, 0.1f, 0.4f, 0.7f, 0.95f, kOneMinus}) {
        const float t = sample->parameter(parts, x);
        ASSERT_TRUE(std::any_of(std::begin(parts), std::end(parts), [t](const Interval& part) {
          return part.begin <= t && t <= part.end;
        })) << t;
        ASSERT_GE(t, last);
        last = t;
      }
    }
  }
}

TEST(ChordSample, AreaShareOfChords) {
  for (const auto& corners : {kRectangle, kTriangle, kPentagon}) {
    const AreaLight light(corners, Rgb(1.0f));
    for (const ChordSet& chords : light.chords) {
      EXPECT_GE(chords.u_of_area(0), 0);
      EXPECT_LE(chords.u_of_area(kOneMinus), chords.extent());
      EXPECT_NEAR(chords.u_of_area(0), 0, 1e-5f);
      EXPECT_NEAR(chords.u_of_area(kOneMinus), chords.extent(), 2e-3f);
      float last = 0;
      for (int i = 1; i < 1000; ++i) {
        const float x = static_cast<float>(i) / 1000, u = chords.u_of_area(x);
        ASSERT_GE(u, last);
        last = u;
        if (i % 50) continue;
        const double below = integrate(
            [&](double v) {
              const auto chord = chords.at(static_cast<float>(v));
              return chord ? chord->length : 0.0;
            },
            0, u, 200);
        EXPECT_NEAR(below / light.area, x, 1e-3) << corners.size();
      }
    }
  }
}

TEST(ChordSample, NothingFromBehind) {
  const AreaLight light(kRectangle, Rgb(1.0f));
  EXPECT_FALSE(sample_chord(light, Vec3(1, 0.5f, -1), 0, 0.5f));
  EXPECT_FALSE(sample_chord(light, Vec3(5, 0.5f, 0), 1, 0.5f));
}

}  // namespace
}  // namespace raytracing
