// Equal time, equal error and the Pareto front, on points with known answers.

#include "raytracing/study/curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raytracing {
namespace {

// error = 1 / seconds^2, then a stretch on which it rises, then it falls again.
const std::vector<CurvePoint> kCurve{{1, 1}, {4, 1.0 / 16}, {8, 0.25}, {16, 0.01}};

TEST(Curves, ErrorAtATimeLiesOnTheLogarithmicLine) {
  EXPECT_DOUBLE_EQ(*error_at(kCurve, 1), 1);
  EXPECT_NEAR(*error_at(kCurve, 2), 0.25, 1e-15);
  EXPECT_NEAR(*error_at(kCurve, 4), 1.0 / 16, 1e-15);
  EXPECT_NEAR(*error_at(kCurve, std::sqrt(8.0 * 16)), 0.05, 1e-15);
  EXPECT_DOUBLE_EQ(*error_at(kCurve, 16), 0.01);
}

TEST(Curves, NothingIsExtrapolated) {
  EXPECT_FALSE(error_at(kCurve, 0.999));
  EXPECT_FALSE(error_at(kCurve, 16.001));
  EXPECT_FALSE(error_at({}, 1));
  EXPECT_FALSE(time_to(kCurve, 0.0099));  // never reached
  EXPECT_FALSE(time_to(kCurve, 1.01));    // reached before the first point
  EXPECT_FALSE(time_to({}, 1));
}

TEST(Curves, TimeToAnErrorIsTheFirst) {
  EXPECT_DOUBLE_EQ(*time_to(kCurve, 1), 1);
  EXPECT_NEAR(*time_to(kCurve, 0.25), 2, 1e-15);
  EXPECT_NEAR(*time_to(kCurve, 1.0 / 16), 4, 1e-15);
  EXPECT_NEAR(*time_to(kCurve, 0.05), std::sqrt(8.0 * 16), 1e-12);
}

TEST(Curves, OnePointIsACurveToo) {
  const std::vector<CurvePoint> one{{2, 0.5}};
  EXPECT_DOUBLE_EQ(*error_at(one, 2), 0.5);
  EXPECT_DOUBLE_EQ(*time_to(one, 0.5), 2);
}

TEST(Curves, ByTimeSorts) {
  const auto sorted = by_time({{3, 1}, {1, 2}, {2, 3}});
  EXPECT_EQ(sorted[0].error, 2);
  EXPECT_EQ(sorted[1].error, 3);
  EXPECT_EQ(sorted[2].error, 1);
}

TEST(Curves, ParetoFrontHoldsWhatNoneBeats) {
  const std::vector<CurvePoint> points{{4, 2}, {1, 5}, {2, 6}, {3, 3}, {3, 4}, {5, 2}, {6, 1}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{1, 3, 0, 6}));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(Curves, RoundNumbers) {
  const std::vector<double> numbers = round_numbers(0.015, 2);
  const std::vector<double> expected{0.02, 0.05, 0.1, 0.2, 0.5, 1, 2};
  ASSERT_EQ(numbers.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(numbers[i], expected[i], 1e-12);
  EXPECT_TRUE(round_numbers(3, 4).empty());
}

TEST(Curves, Median) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
}

}  // namespace
}  // namespace raytracing
