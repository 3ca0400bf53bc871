// The table of finished runs: nothing is lost or changed on the way through the file.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/study/chart/runs.h"
#include "support/temp_dir.h"

namespace raytracing {
namespace {

ChartRun example(std::uint64_t repetition = 3) {
  ChartRun run;
  run.facts.light_sampling = "solid-angle";
  run.facts.spp = 16;
  run.repetition = repetition;
  run.facts.seed = (std::uint64_t{1} << 60) + 1;  // more digits than a double has
  run.facts.render_seconds = 0.1;
  run.facts.cpu_seconds = 1.0 / 3;
  run.facts.rays_closest = 1;
  run.facts.rays_shadow = 2;
  run.facts.segment_queries = 3;
  run.mse = 1e-300;
  run.mse_corrected = -1.25e-5;
  run.relmse = 2.5;
  run.relmse_corrected = std::numeric_limits<double>::quiet_NaN();
  run.smape = 0.25;
  run.facts.mean_r = 0.1;
  run.facts.mean_g = 0.2;
  run.facts.mean_b = 0.3;
  run.facts.non_finite_samples = 7;
  run.largest = 1e30;
  return run;
}

// The log of a folder in which the pictures of repetitions 0 to 2 lie.
struct LogFolder {
  TempDir folder;
  std::string csv = folder / "runs.csv";

  LogFolder() {
    for (const char* name : {"0", "1", "2"})
      folder.write(std::string("runs/solid-angle_16_") + name + ".exr", "a picture");
  }
  RunLog log() const { return RunLog(folder.path()); }
};

TEST(RunLog, RowsKeepEveryDigit) {
  const ChartRun run = example();
  const std::string row = to_csv(run);
  const auto back = run_from_csv(row);
  ASSERT_TRUE(back) << row;
  EXPECT_EQ(to_csv(*back), row);
  EXPECT_EQ(back->facts.light_sampling, run.facts.light_sampling);
  EXPECT_EQ(back->facts.seed, run.facts.seed);
  EXPECT_EQ(back->facts.cpu_seconds, run.facts.cpu_seconds);
  EXPECT_EQ(back->mse_corrected, run.mse_corrected);
  EXPECT_TRUE(std::isnan(back->relmse_corrected));
  EXPECT_EQ(back->facts.mean_b, run.facts.mean_b);
  EXPECT_EQ(back->largest, run.largest);
}

TEST(RunLog, TheHeaderNamesEveryField) {
  const auto count = [](const std::string& s) { return std::count(s.begin(), s.end(), ','); };
  EXPECT_EQ(count(run_csv_header()), count(to_csv(example())));
}

TEST(RunLog, CutOffRowsAreNone) {
  const std::string row = to_csv(example());
  const std::size_t last = row.rfind(',');
  for (std::size_t length = 0; length < last; ++length)
    EXPECT_FALSE(run_from_csv(row.substr(0, length))) << length;
  EXPECT_FALSE(run_from_csv(row + ",1"));
  EXPECT_FALSE(run_from_csv(row + "x"));
}

TEST(RunLog, RowsArePresentAfterReopening) {
  const LogFolder at;
  {
    RunLog log = at.log();
    EXPECT_TRUE(log.runs().empty());
    log.add(example(0));
    EXPECT_EQ(read_file(at.csv), run_csv_header() + "\n" + to_csv(example(0)) + "\n");
    log.add(example(1));
  }
  RunLog log = at.log();
  ASSERT_EQ(log.runs().size(), 2u);
  ASSERT_NE(log.find("solid-angle", 16, 1), nullptr);
  EXPECT_EQ(log.find("solid-angle", 16, 2), nullptr);
  EXPECT_EQ(log.find("solid-angle", 8, 1), nullptr);
  EXPECT_EQ(log.find("point", 16, 1), nullptr);
  EXPECT_EQ(log.at("solid-angle", 16, 1).repetition, 1u);
  EXPECT_THROW(log.at("point", 16, 1), std::out_of_range);
}

TEST(RunLog, ARowThatWasCutOffIsTakenOutAndTold) {
  const LogFolder at;
  const std::string good = run_csv_header() + "\n" + to_csv(example(0)) + "\n";
  const std::string cut_off = good + to_csv(example(1));  // without the line's end
  at.folder.write("runs.csv", cut_off);
  const RunLog log = at.log();
  EXPECT_EQ(log.runs().size(), 1u);
  EXPECT_EQ(log.warnings(),
            std::vector<std::string>{at.csv + ":3: incomplete row (1 in all); rendered again; the "
                                              "old table is kept as runs.csv.old"});
  EXPECT_EQ(read_file(at.csv), good);
  EXPECT_EQ(read_file(at.csv + ".old"), cut_off);
}

// The second time, too, the old table is kept beside the first one.
TEST(RunLog, RowsThatCannotBeReadAreCountedAndKept) {
  const LogFolder at;
  const std::string header = run_csv_header() + "\n", row = to_csv(example(0)) + "\n";
  const std::string torn = header + "x\n" + row + "\n" + to_csv(example(1)) + "\n";
  at.folder.write("runs.csv.old", "older");
  at.folder.write("runs.csv", torn);
  const RunLog log = at.log();
  EXPECT_EQ(log.runs().size(), 2u);
  ASSERT_EQ(log.warnings().size(), 1u);
  EXPECT_TRUE(log.warnings()[0].starts_with(at.csv + ":2: incomplete row (2 in all); "))
      << log.warnings()[0];
  EXPECT_EQ(read_file(at.csv + ".old"), "older");
  EXPECT_EQ(read_file(at.csv + ".old2"), torn);
  EXPECT_EQ(read_file(at.csv), header + row + to_csv(example(1)) + "\n");
  EXPECT_TRUE(at.log().warnings().empty());
}

TEST(RunLog, ARowWithoutItsPictureIsTakenOut) {
  const LogFolder at;
  const std::string good = run_csv_header() + "\n" + to_csv(example(0)) + "\n";
  at.folder.write("runs.csv", good + to_csv(example(9)) + "\n");
  const RunLog log = at.log();
  EXPECT_EQ(log.runs().size(), 1u);
  ASSERT_EQ(log.warnings().size(), 1u);
  EXPECT_TRUE(log.warnings()[0].starts_with(at.csv + ": rows without a picture in runs/: 1; "))
      << log.warnings()[0];
  EXPECT_EQ(read_file(at.csv), good);
  EXPECT_EQ(read_file(at.csv + ".old"), good + to_csv(example(9)) + "\n");
  EXPECT_TRUE(at.log().warnings().empty());
}

TEST(RunLog, AnotherTableIsRefusedAndLeftAlone) {
  const LogFolder at;
  at.folder.write("runs.csv", "a,b\n1,2\n");
  EXPECT_THROW(at.log(), InputError);
  EXPECT_EQ(read_file(at.csv), "a,b\n1,2\n");
}

TEST(RunLog, AFolderThatCannotBeIsAnOutputError) {
  const TempDir folder;
  folder.write("runs", "a file");
  EXPECT_THROW(RunLog(folder.path()), OutputError);
}

}  // namespace
}  // namespace raytracing
