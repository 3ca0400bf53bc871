#include "raytracing/lights/chord_integral.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "raytracing/math/vec.h"
#include "raytracing/study/stress/exact_polygons.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr double kAllowed = 1e-5;  // relative error

struct Case {
  Chord chord;
  Vec3 from, light_normal, n;
  Interval part;
};

// Integrates h (n.foot + s n.d) / (D^2 + s^2)^2 by Gauss-Legendre quadrature in long double, where
// h is the height and D the distance of the line.
long double reference(const Case& c) {
  const LVec3 d(c.chord.direction), r = LVec3(c.chord.begin) - LVec3(c.from);
  // The unit vectors are rounded, so that d.d is not exactly 1.
  const long double dd = dot(d, d), b = dot(r, d) / dd;
  const LVec3 foot = r - b * d;
  const long double h = -dot(foot, LVec3(c.light_normal));
  const long double d2 = dot(foot, foot), nf = dot(LVec3(c.n), foot), nd = dot(LVec3(c.n), d);
  const long double length = c.chord.length;
  const long double s0 = b + length * c.part.begin, s1 = b + length * c.part.end;
  const auto f = [&](long double s) {
    const long double r2 = d2 + dd * s * s;
    return h * (nf + s * nd) / (r2 * r2);
  };
  // The panels are uniform in asinh(s / D), in which the integrand is smooth for any distance.
  const long double scale = std::sqrt(d2);
  const long double a0 = std::asinh(s0 / scale), a1 = std::asinh(s1 / scale);
  constexpr std::array<long double, 4> x{0.18343464249564980494L, 0.52553240991632898582L,
                                         0.79666647741362673959L, 0.96028985649753623168L};
  constexpr std::array<long double, 4> w{0.36268378337836198297L, 0.31370664587788728734L,
                                         0.22238103445337447054L, 0.10122853629037625915L};
  const int panels = 1 + static_cast<int>(std::ceil(4 * (a1 - a0)));
  const long double half = (a1 - a0) / (2.0L * panels);
  long double sum = 0;
  for (int i = 0; i < panels; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      for (long double side : {-1.0L, 1.0L}) {
        const long double a = a0 + (2 * i + 1 + side * x[k]) * half;
        sum += w[k] * half * f(scale * std::sinh(a)) * scale * std::cosh(a);
      }
  return sum;
}

// In this frame the chord starts at the origin along +x and its light faces -z; the point lies at
// (along, aside, height), with height > 0 on the emitting side.
struct Place {
  float along, aside, height;
};

double relative_error(const Place& place, const Vec3& n, const Interval& part) {
  const Vec3 from(place.along, place.aside, -place.height);
  const Case c{{Vec3(0.0f), Vec3(1, 0, 0), 1}, from, Vec3(0, 0, -1), n, part};
  const SeenChord seen(c.chord, c.from, c.light_normal);
  const Interval above = seen.above_horizon(n, part);
  if (!(above.length() >= 0.999f * part.length())) return 0;  // left to the tests of the horizon
  const long double exact = reference(c);
  return static_cast<double>(std::abs(seen.irradiance(n, part) - exact) / std::abs(exact));
}

double worst_over_normals_and_parts(const Place& place, TestRandom& random) {
  double worst = 0;
  for (int i = 0; i < 40; ++i) {
    Vec3 n = random.direction();
    // The chord is well above the horizon; otherwise the result itself is a small difference.
    const auto cosine = [&](float t) {
      return dot(n, normalize(Vec3(t - place.along, -place.aside, place.height)));
    };
    if (cosine(0) < 0) n = -n;
    if (std::min(cosine(0), cosine(1)) < 0.05f) n = Vec3(0, 0, 1);
    const float begin = i % 4 ? random.unit() : 0.0f;
    const float width = i % 4 ? (1 - begin) * std::exp(random.between(-9, 0)) : 1.0f;
    const Interval part{begin, std::min(1.0f, begin + width)};
    if (part.length() > 0) worst = std::max(worst, relative_error(place, n, part));
  }
  return worst;
}

void expect_exact(const char* name, TestRandom& random, const std::function<Place()>& next) {
  double worst = 0;
  Place at{};
  for (int i = 0; i < 2000; ++i) {
    const Place place = next();
    const double error = worst_over_normals_and_parts(place, random);
    if (error > worst) at = place;
    worst = std::max(worst, error);
  }
  EXPECT_LE(worst, kAllowed) << name << " " << at.along << " " << at.aside << " " << at.height;
}

TEST(ChordIntegral, EqualsALongDoubleIntegral) {
  TestRandom random(1);
  const auto size = [&](float low, float high) {
    return std::exp(random.between(std::log(low), std::log(high)));
  };
  const auto sign = [&] { return random.unit() < 0.5f ? -1.0f : 1.0f; };
  expect_exact("ordinary", random, [&] {
    return Place{random.between(-2, 3), random.between(-2, 2), random.between(0.1f, 2)};
  });
  expect_exact("over the middle, near", random, [&] {
    return Place{random.between(0, 1), 0, size(1e-3f, 1e-1f)};
  });
  expect_exact("beyond the end, near the line", random, [&] {
    return Place{random.unit() < 0.5f ? -size(0.01f, 10) : 1 + size(0.01f, 10), 0,
                 size(1e-6f, 1e-2f)};
  });
  expect_exact("seen end-on from far", random, [&] {
    return Place{sign() * size(10, 1e4f), random.between(-1e-3f, 1e-3f), size(1e-4f, 1e-1f)};
  });
  expect_exact("far", random, [&] {
    const Vec3 v = size(10, 1e4f) * random.direction();
    return Place{v.x, v.y, std::abs(v.z) + 1e-3f};
  });
  expect_exact("grazing the light's plane", random, [&] {
    return Place{random.between(-2, 3), sign() * size(0.05f, 2), size(1e-6f, 1e-2f)};
  });
}

TEST(ChordIntegral, NothingBehindTheLightOrWithoutLength) {
  const Chord chord{Vec3(0.0f), Vec3(1, 0, 0), 1};
  const Vec3 n(0, 0, 1);
  EXPECT_EQ(SeenChord(chord, Vec3(0, 0, 1), Vec3(0, 0, -1)).irradiance(-n, {0, 1}), 0.0f);
  EXPECT_EQ(SeenChord(chord, Vec3(3, 1, 0), Vec3(0, 0, -1)).irradiance(n, {0, 1}), 0.0f);
  EXPECT_EQ(SeenChord(chord, Vec3(2, 0, 0), Vec3(0, 0, -1)).irradiance(n, {0, 1}), 0.0f);
  EXPECT_EQ(SeenChord(chord, Vec3(0, 0, -1), Vec3(0, 0, -1)).irradiance(n, {0.5f, 0.5f}), 0.0f);
  EXPECT_GT(SeenChord(chord, Vec3(0, 0, -1), Vec3(0, 0, -1)).irradiance(n, {0, 1}), 0.0f);
}

TEST(ChordIntegral, HorizonCutsWhereTheCosineChangesSign) {
  const SeenChord seen({Vec3(-1, 0, 2), Vec3(1, 0, 0), 4}, Vec3(0.0f), Vec3(0, 0, -1));
  const auto expect = [&](const Vec3& n, const Interval& whole, float begin, float end) {
    const Interval above = seen.above_horizon(normalize(n), whole);
    EXPECT_NEAR(above.begin, begin, 1e-7f);
    EXPECT_NEAR(above.end, end, 1e-7f);
  };
  expect(Vec3(0, 0, 1), {0, 1}, 0, 1);
  expect(Vec3(1, 0, 0), {0, 1}, 0.25f, 1);
  expect(Vec3(-1, 0, 0), {0, 1}, 0, 0.25f);
  expect(Vec3(-1, 0, 1), {0.25f, 0.875f}, 0.25f, 0.75f);
  expect(Vec3(0, 0, -1), {0.25f, 0.875f}, 0.25f, 0.25f);
  expect(Vec3(-1, 0, 0), {0.25f, 1}, 0.25f, 0.25f);
}

// Chords over a rectangle sum to Lambert's formula for polygons, with and without a horizon.
TEST(ChordIntegral, ChordsOfARectangleMakeLambertsFormula) {
  TestRandom random(2);
  const std::vector<Vec3> corners{Vec3(-1, -0.5f, 2), Vec3(-1, 0.5f, 2), Vec3(1, 0.5f, 2),
                                  Vec3(1, -0.5f, 2)};
  const Vec3 light_normal(0, 0, -1);
  for (int round = 0; round < 300; ++round) {
    const Vec3 from(random.between(-3, 3), random.between(-3, 3), random.between(-3, 1.5f));
    const Vec3 n = random.direction();
    const auto at = [&](double y) {
      const SeenChord seen({Vec3(-1, y, 2), Vec3(1, 0, 0), 2}, from, light_normal);
      return static_cast<double>(seen.irradiance(n, seen.above_horizon(n, {0, 1})));
    };
    const auto exact = static_cast<double>(lambert(long_polygon(corners), LVec3(from), LVec3(n)));
    // Many panels are needed, because the profile has a kink where the horizon leaves the chords.
    EXPECT_NEAR(integrate(at, -0.5, 0.5, 64), exact, 2e-5 * exact + 2e-6) << round;
  }
}

}  // namespace
}  // namespace raytracing
