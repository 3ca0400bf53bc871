// Fits of y = c x^slope: known slopes, Student's distribution, coverage of the interval.

#include "raytracing/study/power_law.h"

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
  EXPECT_NEAR(fit->at(32), 3 * std::pow(32, -1.5), 1e-12);
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

}  // namespace
}  // namespace raytracing
