// The judges judged: known values of the statistical helpers.

#include "support/statistics.h"

#include <gtest/gtest.h>

namespace raytracing {
namespace {

TEST(Statistics, GammaQHasTheClosedFormsOfIntegerAndHalf) {
  for (double x : {1e-3, 0.1, 1.0, 2.5, 10.0, 60.0}) {
    EXPECT_NEAR(gamma_q(1, x), std::exp(-x), 1e-13);
    EXPECT_NEAR(gamma_q(2, x), (1 + x) * std::exp(-x), 1e-13);
    EXPECT_NEAR(gamma_q(0.5, x), std::erfc(std::sqrt(x)), 1e-13);
  }
  EXPECT_NEAR(gamma_q(500, 500), 0.49405, 1e-4);
}

TEST(Statistics, ChiSquarePoolsSmallCellsAndSeesImpossibleOnes) {
  // (10-8)^2/8 + (6-8)^2/8 = 1 with one degree of freedom: p = erfc(sqrt(1/2)).
  const ChiSquare plain = chi_square_uniform(std::vector<double>{10, 6});
  EXPECT_EQ(plain.degrees, 1);
  EXPECT_NEAR(plain.p_value, std::erfc(std::sqrt(0.5)), 1e-12);
  const std::vector<double> expected{1, 1, 1, 2, 20, 20};
  const ChiSquare pooled = chi_square_test(std::vector<double>{0, 2, 1, 2, 22, 18}, expected);
  EXPECT_EQ(pooled.degrees, 2);
  EXPECT_NEAR(pooled.statistic, 0.4, 1e-12);
  EXPECT_EQ(chi_square_test(std::vector<double>{1, 99}, std::vector<double>{0, 1}).p_value, 0);
}

// If the null hypothesis holds, p-values are uniform.
TEST(Statistics, ChiSquarePValuesOfUniformNumbersAreUniform) {
  TestRandom random(1);
  std::vector<double> p_counts(10);
  for (int repeat = 0; repeat < 1000; ++repeat) {
    std::vector<double> counts(20);
    for (int i = 0; i < 1000; ++i) ++counts[cell_of(random.unit(), counts.size())];
    ++p_counts[cell_of(chi_square_uniform(counts).p_value, p_counts.size())];
  }
  EXPECT_GT(chi_square_uniform(p_counts).p_value, kFamilyLevel);
}

TEST(Statistics, MeanVarianceAndQuadrature) {
  RunningStats stats;
  for (double x : {1.0, 2.0, 3.0, 4.0}) stats.add(x);
  EXPECT_DOUBLE_EQ(stats.mean(), 2.5);
  EXPECT_DOUBLE_EQ(stats.variance(), 5.0 / 3);
  EXPECT_NEAR(mean_p_value(stats, 2.5 + 1.96 * stats.standard_error()), 0.05, 1e-4);
  EXPECT_NEAR(integrate([](double x) { return std::pow(x, 15); }, 0, 1), 1.0 / 16, 1e-15);
  EXPECT_NEAR(integrate2([](double x, double y) { return x * std::cos(y); }, 0, 2, 0, 1),
              2 * std::sin(1.0), 1e-14);
  EXPECT_NEAR(sidak_level(1e-3, 100), 1e-5, 1e-8);
}

}  // namespace
}  // namespace raytracing
