// What a chart concludes from points with known answers.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "raytracing/study/chart/summary.h"
#include "study/made_up_chart.h"

namespace raytracing {
namespace {

const NoiseFloor kFloor{{1e-5, 1e-6}, {1e-4, 1e-5}};

TEST(ChartSummary, SpreadIsMedianAndEnds) {
  const Spread s = spread({3, 1, 2});
  EXPECT_EQ(s.median, 2);
  EXPECT_EQ(s.low, 1);
  EXPECT_EQ(s.high, 3);
}

TEST(ChartSummary, KnownSlopesAreRecovered) {
  const ChartSummary exact = made_up_chart(std::nullopt);
  EXPECT_NEAR(exact.methods[0].over_spp->slope, -1, 1e-12);
  EXPECT_NEAR(exact.methods[1].over_time->slope, -1.5, 1e-12);
  const ChartSummary noisy = made_up_chart(std::nullopt, 0.3);
  for (const auto& [m, slope] : {std::pair{0, -1.0}, {1, -1.5}}) {
    const auto interval = noisy.methods[static_cast<std::size_t>(m)].over_spp->slope_interval;
    EXPECT_LT(interval->low, slope);
    EXPECT_GT(interval->high, slope);
    EXPECT_LT(interval->high - interval->low, 0.3);
  }
}

// point: relMSE = 0.001 / seconds from 0.01 s to 0.64 s; line: 0.2 (seconds / 0.02)^-1.5 from
// 0.02 s to 1.28 s; they meet at 0.32 s.
TEST(ChartSummary, EqualTimeEqualErrorAndFront) {
  const ChartSummary s = made_up_chart(std::nullopt);
  const auto j = to_json(s);
  ASSERT_EQ(j["equal_time"].size(), 7u);  // 0.01 0.02 0.05 0.1 0.2 0.5 1
  const auto& at = [&](std::size_t i) { return j["equal_time"][i]; };
  EXPECT_NEAR(at(0)["relmse"]["point"], 0.1, 1e-12);
  EXPECT_TRUE(at(0)["relmse"]["line"].is_null());
  EXPECT_NEAR(at(2)["relmse"]["point"], 0.02, 1e-12);
  EXPECT_NEAR(at(2)["relmse"]["line"], 0.2 * std::pow(2.5, -1.5), 1e-12);
  EXPECT_TRUE(at(6)["relmse"]["point"].is_null());
  for (const auto& row : j["equal_error"]) {
    const double error = row["relmse"];
    const auto& point = row["seconds"]["point"];
    const auto& line = row["seconds"]["line"];
    EXPECT_EQ(point.is_null(), error > 0.1 * (1 + 1e-9) || error < 0.1 / 64) << error;
    EXPECT_EQ(line.is_null(), error > 0.2 * (1 + 1e-9) || error < 0.2 / 512) << error;
    if (!point.is_null()) {
      EXPECT_NEAR(point, 0.001 / error, 1e-9);
    }
    if (!line.is_null()) {
      EXPECT_NEAR(line, 0.02 * std::pow(error / 0.2, -1 / 1.5), 1e-9);
    }
  }
  // Before they meet points are better, after that lines.
  std::vector<std::string> front;
  for (const auto& p : j["pareto_front"]) front.push_back(p["method"]);
  EXPECT_EQ(front, (std::vector<std::string>{"point", "point", "point", "point", "point", "point",
                                             "line", "line"}));
}

TEST(ChartSummary, PointsLostInTheFloorAreLeftOut) {
  NoiseFloor floor = kFloor;
  floor.relmse.standard_error = 0.0005;
  std::vector<MethodSummary> methods{made_up_method("line", 0.2, -1.5, 0.02, 0, 1)};
  methods[0].points[6].relmse_corrected.median = -1e-6;
  const ChartSummary s = summarise(methods, floor);
  const MethodSummary& m = s.methods[0];
  for (const ChartPoint& p : m.points)
    EXPECT_EQ(p.measurable, p.relmse_corrected.median > 0.001) << p.spp;
  EXPECT_EQ(m.curve.size(), 6u);
  EXPECT_EQ(m.over_spp->points, 6);
  EXPECT_NEAR(m.over_spp->slope, -1.5, 1e-12);
  EXPECT_EQ(to_json(s)["methods"][0]["points"][6]["above_floor"], false);
}

TEST(ChartSummary, WithoutAnyMeasurablePointTablesAreEmpty) {
  NoiseFloor floor = kFloor;
  floor.relmse.standard_error = 1;
  const ChartSummary s = made_up_chart(floor);
  EXPECT_FALSE(s.methods[0].over_spp);
  EXPECT_TRUE(s.equal_time.empty());
  const auto j = to_json(s);
  EXPECT_TRUE(j["equal_time"].empty());
  EXPECT_TRUE(j["methods"][0]["fit_over_spp"].is_null());
  EXPECT_TRUE(j["methods"][0]["bias"].is_null());
}

TEST(ChartSummary, UnknownFloorIsNullAndTheRawErrorsAreUsed) {
  std::vector<MethodSummary> methods{made_up_method("line", 0.2, -1.5, 0.02, 0, 1)};
  for (ChartPoint& p : methods[0].points) p.relmse_corrected = {NAN, NAN, NAN};
  const ChartSummary s = summarise(methods, std::nullopt);
  EXPECT_NEAR(s.methods[0].over_spp->slope, -1.5, 1e-12);
  const auto j = to_json(s);
  EXPECT_TRUE(j["noise_floor"].is_null());
  EXPECT_TRUE(j["methods"][0]["points"][0]["relmse_corrected"]["median"].is_null());
}

}  // namespace
}  // namespace raytracing
