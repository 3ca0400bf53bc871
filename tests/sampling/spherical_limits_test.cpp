// Solid-angle sampling of rectangles changes from float to double at some limits, and lights change
// from it to area sampling at others. The results on both sides of each limit are the same.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "raytracing/lights/area_light.h"
#include "raytracing/lights/chord.h"
#include "raytracing/sampling/spherical.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr double kFloatLow = 0.01, kFloatHigh = 6;  // SphericalRectangle uses float between these
constexpr double kUsableLow = 3e-3,
                 kUsableHigh = 6.2831;  // lights are sampled by area outside these

AreaLight light_of(const Rectangle& r) {
  const Vec3 x = r.width * r.x, y = r.height * r.y;
  return {std::vector<Vec3>{r.corner, r.corner + x, r.corner + x + y, r.corner + y}, Rgb(1)};
}

// A rectangle in the plane z = 0 and points above the origin, which lies in it or beside it.
struct Setting {
  AreaLight light;
  Rectangle rectangle;  // the shape of the light
  bool inside;
  Vec3 at(float height) const { return {0, 0, height}; }
  double solid_angle(float height) const {
    return SphericalRectangle(rectangle, at(height)).solid_angle();
  }
};

Setting random_setting(TestRandom& random, bool inside) {
  const float width = random.between(0.5f, 2), height = random.between(0.5f, 2);
  const float x = inside ? random.between(0.2f, 0.8f) : random.between(1.3f, 2);
  const float y = inside ? random.between(0.2f, 0.8f) : random.between(-1, 2);
  const AreaLight light =
      light_of({{-x * width, -y * height, 0}, {1, 0, 0}, {0, 1, 0}, width, height});
  return {light, light.rectangle.value(), inside};
}

// Neighbouring heights on both sides of a limit of the solid angle.
struct Sides {
  float more, less;  // the heights with the larger and the smaller solid angle
};

Sides sides_of(const Setting& setting, double limit, Sides sides) {
  for (;;) {
    const float middle = sides.more + (sides.less - sides.more) / 2;
    if (middle == sides.more || middle == sides.less) return sides;
    (setting.solid_angle(middle) > limit ? sides.more : sides.less) = middle;
  }
}

// Calls `check` for many settings and the two sides of a limit. The point is above the rectangle
// or, where the solid angle is small enough there, beside it at a grazing angle.
void for_sides(double limit, const std::function<void(const Setting&, const Sides&)>& check) {
  TestRandom random(1);
  for (int i = 0; i < 200; ++i) {
    const bool inside = limit > 1 || i % 2 == 0;
    const Setting setting = random_setting(random, inside);
    const Sides sides = inside ? Sides{1e-7f, 100} : Sides{0.5f, 1e-6f};
    ASSERT_GT(setting.solid_angle(sides.more), limit);
    ASSERT_LT(setting.solid_angle(sides.less), limit);
    check(setting, sides_of(setting, limit, sides));
  }
}

// Neighbouring heights, and their solid angles, differ by at most a relative 1e-7.
TEST(SphericalLimits, SolidAnglesAreContinuous) {
  for (const double limit : {kFloatLow, kFloatHigh, kUsableLow, kUsableHigh})
    for_sides(limit, [&](const Setting& setting, const Sides& sides) {
      const double step = setting.solid_angle(sides.more) - setting.solid_angle(sides.less);
      EXPECT_GE(step, 0);
      EXPECT_LE(step, 3e-7 * limit) << limit;
    });
}

// The samples lie on a rectangle of about unit size. Where its solid angle is large, samples near
// the horizon move far for a small change of it.
TEST(SphericalLimits, SamplesAreContinuousWhereTheArithmeticChanges) {
  struct Tolerance {
    double limit, mean, worst;
  };
  for (const auto& [limit, mean, worst] :
       {Tolerance{kFloatLow, 2e-6, 4e-4}, Tolerance{kFloatHigh, 1e-6, 1e-3}}) {
    TestRandom random(2);
    RunningStats distance;
    for_sides(limit, [&](const Setting& setting, const Sides& sides) {
      const SphericalRectangle more(setting.rectangle, setting.at(sides.more));
      const SphericalRectangle less(setting.rectangle, setting.at(sides.less));
      for (int i = 0; i < 20; ++i) {
        const Vec2 u = random.unit2();
        distance.add(length(more.sample(u) - less.sample(u)));
        EXPECT_LE(length(more.sample(u) - less.sample(u)), worst) << limit;
        EXPECT_LE(std::abs(more.strip(u.x).x - less.strip(u.x).x), worst) << limit;
      }
    });
    EXPECT_LE(distance.mean(), mean) << limit;
  }
}

// Returns the mean of 1 / pdf over points uniform in area. For the density of such points per solid
// angle it is the solid angle. It is integrated in polar coordinates around the foot, because from
// close by only the neighbourhood of the foot matters.
double mean_inverse(const Setting& setting, float height, const std::function<double(Vec3)>& pdf) {
  const auto inverse = [&](double x, double y) { return 1 / pdf(Vec3(x, y, 0)); };
  const Rectangle& r = setting.rectangle;
  const double x0 = r.corner.x, y0 = r.corner.y, x1 = x0 + r.width, y1 = y0 + r.height;
  const double area = (x1 - x0) * (y1 - y0);
  if (!setting.inside) return integrate2(inverse, x0, x1, y0, y1, 8) / area;
  const DVec2 corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    const DVec2 a = corners[i], b = corners[(i + 1) % 4];
    // This is the triangle of the foot and one edge; the distance from the foot is height *
    // sinh(s).
    sum += integrate(
        [&](double t) {
          const DVec2 edge = a + t * (b - a);
          const double end = length(edge), angle = (a.x * b.y - a.y * b.x) / dot(edge, edge);
          const auto ring = [&](double s) {
            const double distance = height * std::sinh(s), scale = distance / end;
            return inverse(scale * edge.x, scale * edge.y) * distance * height * std::cosh(s);
          };
          return angle * integrate(ring, 0, std::asinh(end / height), 8);
        },
        0, 1, 4);
  }
  return sum / area;
}

// Lights have different densities on the two sides of a limit. Each is the density of the samples
// on its side, and both give the same solid angle with a relative error of at most 1e-4.
TEST(SphericalLimits, LightsChangeToSamplingByAreaWithoutAStepOfTheSolidAngle) {
  for (const double limit : {kUsableLow, kUsableHigh})
    for_sides(limit, [&](const Setting& setting, const Sides& sides) {
      const AreaLight& light = setting.light;
      const bool low = limit < 1;
      const float usable = low ? sides.more : sides.less, other = low ? sides.less : sides.more;
      const Vec3 from_usable = setting.at(usable), from_other = setting.at(other);
      const auto by_angle = sample_solid_angle(light, from_usable, {0.3f, 0.7f});
      const auto by_area = sample_solid_angle(light, from_other, {0.3f, 0.7f});
      ASSERT_TRUE(by_angle && by_area);
      EXPECT_FALSE(by_angle->by_area);
      EXPECT_TRUE(by_area->by_area);
      EXPECT_NEAR(by_angle->pdf_w * limit, 1, 1e-6);
      EXPECT_EQ(by_area->pdf_w, solid_angle_pdf_w(light, from_other, by_area->point));
      EXPECT_NEAR(sample_chord(light, from_usable, 0, 0.3f)->solid_angle, limit, 1e-6 * limit);
      EXPECT_EQ(sample_chord(light, from_other, 0, 0.3f)->solid_angle, 0);
      for (const auto& density : {solid_angle_pdf_w, chord_pdf_w}) {
        const auto mean = [&](float height) {
          return mean_inverse(setting, height,
                              [&](const Vec3& q) { return density(light, setting.at(height), q); });
        };
        EXPECT_NEAR(mean(usable), limit, 1e-4 * limit);
        EXPECT_NEAR(mean(other), limit, 1e-4 * limit) << setting.inside;
      }
    });
}

// Returns the solid angle of the part of the rectangle up to x, from the corner, in closed form.
double solid_angle_up_to(double x, const Rectangle& r, double height) {
  const auto corner = [&](long double u, long double v) {
    const long double h = height;
    return std::atan2(u * v, h * std::sqrt(u * u + v * v + h * h));
  };
  const long double x0 = r.corner.x, y0 = r.corner.y, x1 = x0 + x, y1 = y0 + r.height;
  return static_cast<double>(corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0));
}

// The strip of a uniform number u has the fraction u of the solid angle before it. In float, for a
// point beside the rectangle and 1e-4 above its plane, the mean error was .018 and the worst .99.
TEST(SphericalLimits, StripsHaveTheirShareBeforeThemAlsoSeenByGrazingSight) {
  TestRandom random(4);
  for (const float height : {1.0f, 0.3f, 0.1f, 0.03f, 0.01f, 1e-3f, 1e-4f}) {
    double worst_mean = 0, worst = 0;
    for (int i = 0; i < 4000; ++i) {
      const Rectangle r{{random.between(-3, 2), random.between(-3, 2), 0},
                        {1, 0, 0},
                        {0, 1, 0},
                        random.between(0.5f, 2),
                        random.between(0.5f, 2)};
      const SphericalRectangle seen(r, {0, 0, height});
      if (seen.solid_angle() < kUsableLow || seen.solid_angle() > kUsableHigh) continue;
      RunningStats error;
      for (int k = 0; k < 50; ++k) {
        const float u = (static_cast<float>(k) + 0.5f) / 50;
        const double share = solid_angle_up_to(seen.strip(u).x, r, height) / seen.solid_angle();
        error.add(share - static_cast<double>(u));
        worst = std::max(worst, std::abs(share - static_cast<double>(u)));
      }
      worst_mean = std::max(worst_mean, std::abs(error.mean()));
    }
    EXPECT_LE(worst_mean, 1.5e-4) << height;
    EXPECT_LE(worst, 1e-3) << height;
  }
}

// Above a light, the two densities are nearly the same at the lower limit.
TEST(SphericalLimits, FarOverALightTheTwoDensitiesAreNearlyTheSame) {
  TestRandom random(3);
  for_sides(kUsableLow, [&](const Setting& setting, const Sides& sides) {
    if (!setting.inside) return;
    const AreaLight& light = setting.light;
    const auto by_area = sample_solid_angle(light, setting.at(sides.less), random.unit2());
    EXPECT_NEAR(by_area->pdf_w * kUsableLow, 1, 0.01);
  });
}

}  // namespace
}  // namespace raytracing
