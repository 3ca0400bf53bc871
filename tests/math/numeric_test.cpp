#include "raytracing/math/numeric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace raytracing {
namespace {

constexpr double kBound = 1e-7;  // the documented error
constexpr int kSteps = 1 << 20;

TEST(Circle, EighthIsCosineAndSine) {
  double worst = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const float t = static_cast<float>(i) / kSteps;
    const Vec2 p = circle_eighth(t);
    const double angle = std::numbers::pi / 4 * static_cast<double>(t);
    worst = std::max({worst, std::abs(p.x - std::cos(angle)), std::abs(p.y - std::sin(angle))});
  }
  EXPECT_LT(worst, kBound);
}

TEST(Circle, WholeTurnIsCosineAndSine) {
  double worst = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const float u = static_cast<float>(i) / kSteps;
    const Vec2 p = circle(u);
    const double angle = 2 * std::numbers::pi * static_cast<double>(u);
    worst = std::max({worst, std::abs(p.x - std::cos(angle)), std::abs(p.y - std::sin(angle))});
  }
  EXPECT_LT(worst, kBound);
}

TEST(Circle, MeetsTheAxes) {
  EXPECT_EQ(circle(0.0f), Vec2(1, 0));
  EXPECT_EQ(circle(0.25f), Vec2(0, 1));
  EXPECT_EQ(circle(0.5f), Vec2(-1, 0));
  EXPECT_EQ(circle(0.75f), Vec2(0, -1));
}

}  // namespace
}  // namespace raytracing
