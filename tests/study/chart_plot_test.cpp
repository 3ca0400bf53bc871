// Data and script for gnuplot, and running it.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/study/chart/plot.h"
#include "raytracing/study/page/result_folder.h"
#include "study/made_up_chart.h"
#include "support/temp_dir.h"

namespace raytracing {
namespace {

const NoiseFloor kFloor{{1e-5, 1e-6}, {1e-4, 1e-5}};

bool has_gnuplot() { return std::system("gnuplot --version >/dev/null 2>&1") == 0; }

TEST(ChartPlot, WhatIsNotAboveZeroIsOffTheAxis) {
  std::vector<MethodSummary> methods{made_up_method("line", 0.2, -1.5, 0.02, 0, 1)};
  methods[0].points.resize(2);
  methods[0].points[0].relmse_corrected = {0.2, -0.1, 0.3};
  methods[0].points[1].relmse_corrected = {-0.2, -0.3, 0.1};
  const ChartSummary summary = summarise(methods, kFloor);
  const std::string data = plot_data(summary, 1e-5);
  EXPECT_NE(data.find("\n1 0.02 0.018 0.024 0.2 1e-05 0.3\n"), std::string::npos) << data;
  EXPECT_NE(data.find("\n2 0.04 0.036 0.048 NaN 1e-05 0.1\n"), std::string::npos) << data;
}

TEST(ChartPlot, TheAxisEndsBelowPointsAndFloor) {
  EXPECT_DOUBLE_EQ(plot_bottom(made_up_chart(std::nullopt)), 1e-4);  // least: 3.9e-4
  EXPECT_DOUBLE_EQ(plot_bottom(made_up_chart(kFloor)), 1e-5);
  NoiseFloor low = kFloor;
  low.relmse = {1e-9, 1e-10};  // too far below to be shown
  EXPECT_DOUBLE_EQ(plot_bottom(made_up_chart(low)), 1e-4);
}

TEST(ChartPlot, GnuplotDrawsIntoAnyFolder) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is missing";
  const TempDir temp;
  const std::string folder = temp / "it's $HOME `x` \"y\" %d";
  std::filesystem::create_directory(folder);
  const ChartSummary summary = made_up_chart(kFloor, 0.2);
  const std::string in_folder = std::filesystem::path(folder).filename().string() + "/";
  temp.write(in_folder + "chart.dat", plot_data(summary, plot_bottom(summary)));
  temp.write(in_folder + "chart.gp", plot_script(summary, "it's `touch x` \"a\" \\ _b_ ^c {d} %e"));
  ASSERT_TRUE(run_gnuplot(folder, "chart.gp"));
  for (const char* name : {"/error_vs_time", "/error_vs_spp"}) {
    const std::string svg = read_file(folder + name + ".svg");
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_NE(svg.find("line"), std::string::npos);
    EXPECT_NE(svg.find("s `touch x` "), std::string::npos);  // as it stands, not carried out
    EXPECT_TRUE(read_file(folder + name + ".png").starts_with("\x89PNG"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder + "/x"));
}

// Pictures of a few pixels take 2e-5 s: gnuplot refuses a place of a tic that is written so.
TEST(ChartPlot, ShortTimesHaveTicsWithoutAnExponent) {
  const ChartSummary summary =
      summarise({made_up_method("line", 0.2, -1.5, 2e-5, 0, 1)}, std::nullopt);
  const std::string script = plot_script(summary, "short");
  const std::size_t begin = script.find("array tics[2] = ");
  const std::string tics = script.substr(begin, script.find('\n', begin) - begin);
  EXPECT_NE(tics.find("0.0000"), std::string::npos) << tics;
  EXPECT_EQ(tics.find("e-"), std::string::npos) << tics;
}

TEST(ChartPlot, AFailureOfGnuplotIsAnOutputError) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is missing";
  const TempDir folder;
  folder.write("chart.gp", "set output 'no/such/folder/x'\nplot x\nexit status 3\n");
  EXPECT_THROW(run_gnuplot(folder.path(), "chart.gp"), OutputError);
}

}  // namespace
}  // namespace raytracing
