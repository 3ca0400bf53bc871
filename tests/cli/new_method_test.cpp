// A method that is added by one file and one row appears in help, pictures, chart and stress: the
// program under test is built with the method point-2 of tests/examples.

#include <gtest/gtest.h>

#include "support/cli_folder.h"

namespace raytracing {
namespace {

class NewMethod : public ::testing::Test {
 protected:
  RunResult run(Names arguments) const {
    arguments.insert(arguments.begin(), RAYTRACING_WITH_POINT_2);
    RunOptions options;
    options.folder = at_.folder.path();
    return run_any(arguments, options);
  }
  double mean_red(const std::string& method, const std::string& reuse) const {
    const RunResult r = run({kCornell, "--width=48", "--height=48", "--spp=64", "--reuse", reuse,
                             "--light-sampling", method, "--stats=s.json", "--output=s.exr"});
    EXPECT_EQ(r.exit_code, 0) << r.err;
    return at_.json("s.json")["mean_r"];
  }
  CliFolder at_;
};

TEST_F(NewMethod, IsListedInTheHelp) {
  EXPECT_NE(run({"--help"}).out.find("point-2"), std::string::npos);
  EXPECT_NE(run({"--list-methods"}).out.find("2 shadow rays"), std::string::npos);
}

TEST_F(NewMethod, RendersTheSamePictureInBothModes) {
  const double truth = mean_red("solid-angle", "1");
  for (const char* reuse : {"1", "16"}) EXPECT_NEAR(mean_red("point-2", reuse) / truth, 1, 0.01);
}

TEST_F(NewMethod, IsCharted) {
  const RunResult r = run({"chart", kCornell, "--out=c", "--width=12", "--height=12",
                           "--max-depth=1", "--spp=1,2", "--seeds=2", "--reference-time=0.01"});
  ASSERT_EQ(r.exit_code, 0) << r.err;
  EXPECT_NE(at_.bytes("c/runs.csv").find("point-2,"), std::string::npos);
  EXPECT_NE(at_.bytes("c/chart.gp").find("#009e73"), std::string::npos);
  EXPECT_NE(at_.bytes("c/report.html").find("point-2"), std::string::npos);
}

TEST_F(NewMethod, IsStressed) {
  const RunResult r = run({"stress", "--out=s", "--case=contact", "--seeds=1"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_NE(at_.bytes("s/stress.csv").find("point-2"), std::string::npos);
}

}  // namespace
}  // namespace raytracing
