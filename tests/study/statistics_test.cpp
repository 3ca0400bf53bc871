// Student's distribution, fits of power laws, equal time and equal error, the Pareto front.

#include "raytracing/study/metrics/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "support/statistics.h"

namespace raytracing {
namespace {

TEST(PowerLaw, StudentsQuantilesAreThoseOfTheTables) {
  // Abramowitz and Stegun 1964, table 26.10.
  EXPECT_NEAR(student_t_quantile(0.95, 1), 12.706, 5e-4);
  EXPECT_NEAR(student_t_quantile(0.95, 2), 4.303, 5e-4);
  EXPECT_NEAR(student_t_quantile(0.95, 5), 2.571, 5e-4);
  EXPECT_NEAR(student_t_quantile(0.99, 10), 3.169, 5e-4);
  EXPECT_NEAR(student_t_quantile(0.5, 3), 0.765, 5e-4);
  EXPECT_NEAR(student_t_quantile(0.95, 1000000), 1.959966, 1e-5);
}

TEST(PowerLaw, ExactPointsGiveTheirSlope) {
  const std::vector<double> x{1, 2, 4, 8, 16};
  std::vector<double> y;
  for (const double v : x) y.push_back(3 * std::pow(v, -1.5));
  const auto fit = fit_power_law(x, y);
  ASSERT_TRUE(fit && fit->slope_interval);
  EXPECT_NEAR(fit->slope, -1.5, 1e-12);
  EXPECT_NEAR(fit->slope_interval->low, -1.5, 1e-6);
  EXPECT_NEAR(fit->slope_interval->high, -1.5, 1e-6);
  EXPECT_NEAR(std::exp(fit->log_scale), 3, 1e-12);
  EXPECT_EQ(fit->points, 5);
}

TEST(PowerLaw, TwoPointsHaveASlopeWithoutInterval) {
  const auto fit = fit_power_law(std::vector<double>{1, 10}, std::vector<double>{1, 0.01});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, -2, 1e-12);
  EXPECT_FALSE(fit->slope_interval);
}

TEST(PowerLaw, OnePlaceHasNoSlope) {
  EXPECT_FALSE(fit_power_law(std::vector<double>{2, 2, 2}, std::vector<double>{1, 2, 3}));
  EXPECT_FALSE(fit_power_law(std::vector<double>{2}, std::vector<double>{1}));
  EXPECT_FALSE(fit_power_law({}, {}));
}

// Of 4000 intervals, 95 % hold the slope; z-test of the share.
TEST(PowerLaw, IntervalsCoverTheSlope) {
  constexpr int kRepetitions = 4000;
  constexpr double kSlope = -1.3;
  std::mt19937_64 engine(7);
  std::normal_distribution<double> noise(0, 0.2);
  for (const int count : {3, 7}) {
    int covered = 0;
    for (int r = 0; r < kRepetitions; ++r) {
      std::vector<double> x, y;
      for (int i = 0; i < count; ++i) {
        x.push_back(std::exp2(i));
        y.push_back(0.4 * std::pow(x.back(), kSlope) * std::exp(noise(engine)));
      }
      const auto interval = fit_power_law(x, y)->slope_interval;
      covered += interval->low <= kSlope && kSlope <= interval->high;
    }
    const double share = static_cast<double>(covered) / kRepetitions;
    const double z = (share - 0.95) / std::sqrt(0.95 * 0.05 / kRepetitions);
    EXPECT_GT(normal_p_value(z), sidak_level(kFamilyLevel, 2)) << count << " " << share;
  }
}

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
