// The subcommand chart: what it leaves behind, that it resumes, and what it refuses.

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include "raytracing/study/chart/runs.h"
#include "support/cli_folder.h"

namespace raytracing {
namespace {

/// A small chart of two methods, with more options.
Names arguments(const Names& more) {
  Names result{"chart",
               kCornell,
               "--out=c",
               "--width=12",
               "--height=12",
               "--max-depth=1",
               "--methods=point,line",
               "--spp=1,2,4",
               "--seeds=3",
               "--reference-time=0.01"};
  for (const std::string& m : more) {
    const std::string name = m.substr(0, m.find('='));
    std::erase_if(result, [&](const std::string& r) { return r.starts_with(name + "="); });
    result.push_back(m);
  }
  return result;
}

class ChartCommand : public ::testing::Test {
 protected:
  RunResult chart(const Names& more = {}) const { return at_.run(arguments(more)); }
  bool exists(const std::string& name) const { return std::filesystem::exists(at_.folder / name); }
  std::size_t pictures() const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(at_.folder / "c/runs"))
      count += entry.path().extension() == ".exr";
    return count;
  }
  CliFolder at_;
};

TEST_F(ChartCommand, LeavesTablesPicturesAndAPage) {
  const RunResult run = chart();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(pictures(), 18u);
  EXPECT_EQ(lines_of(at_.bytes("c/runs.csv")), 19u);
  for (const char* name : {"c/summary.json", "c/chart.dat", "c/chart.gp", "c/report.html"}) {
    EXPECT_TRUE(exists(name)) << name;
    EXPECT_NE(run.out.find(std::string(name) + "\n"), std::string::npos) << name;
  }
  const nlohmann::json j = at_.json("c/summary.json");
  EXPECT_EQ(j["max_depth"], 1);
  EXPECT_GT(j["noise_floor"]["relmse"]["value"], 0);
  EXPECT_EQ(j["reference_non_finite_samples"], 0);
  ASSERT_EQ(j["methods"].size(), 2u);
  for (const auto& method : j["methods"]) {
    EXPECT_EQ(method["points"].size(), 3u);
    EXPECT_LT(method["fit_over_spp"]["slope"], -0.5);
    EXPECT_EQ(method["points"][0]["seeds"], 3);
    EXPECT_FALSE(method["bias"].is_null());
  }
  EXPECT_NE(at_.bytes("c/report.html").find("Error against time: cornell, 12x12, direct light"),
            std::string::npos);
}

TEST_F(ChartCommand, ResumesAndRepeatsNothing) {
  ASSERT_EQ(chart().exit_code, 0);
  const std::string before = at_.bytes("c/runs.csv");
  const RunResult again = chart();
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_NE(again.err.find("18 runs, 18 of them finished before"), std::string::npos) << again.err;
  EXPECT_EQ(again.err.find("rendering the reference"), std::string::npos);
  EXPECT_EQ(at_.bytes("c/runs.csv"), before);
  const RunResult more = chart({"--seeds=4", "--methods=point"});
  EXPECT_NE(more.err.find("12 runs, 9 of them finished before"), std::string::npos) << more.err;
  EXPECT_TRUE(at_.bytes("c/runs.csv").starts_with(before));
  EXPECT_EQ(lines_of(at_.bytes("c/runs.csv")), 22u);
  std::filesystem::remove(at_.folder / "c/runs/point_2_1.exr");
  const RunResult mended = chart();
  EXPECT_NE(mended.err.find("18 runs, 17 of them finished before"), std::string::npos);
  EXPECT_NE(mended.err.find("warning: c/runs.csv: rows without a picture in runs/: 1; rendered "
                            "again; the old table is kept as runs.csv.old\n"),
            std::string::npos)
      << mended.err;
  EXPECT_EQ(pictures(), 21u);
}

// The radiance overflows when light is added to it.
TEST_F(ChartCommand, CountsAndTellsNonFiniteSamplesOfTheReference) {
  at_.folder.write("s.toml",
                   "[film]\nwidth = 4\nheight = 4\n[camera]\norigin = [0,0,2]\n"
                   "target = [0,0,0]\n[materials.sun]\ntype = 'diffuse'\nreflectance = 1\n"
                   "emission = 3e38\n[[models]]\nobj = 'm.obj'\nmaterial = 'sun'\n");
  at_.folder.write("m.obj",
                   "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 1\nv 1 -1 1\n"
                   "f 1 2 3 4\nf 5 6 2 1\n");
  const RunResult run = at_.run({"chart", "s.toml", "--out=c", "--methods=point", "--spp=1",
                                 "--seeds=2", "--reference-time=0.001"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::uint64_t count = at_.json("c/summary.json").value("reference_non_finite_samples", 0u);
  EXPECT_GT(count, 0u);
  EXPECT_NE(run.err.find(std::to_string(count) +
                         " samples of the reference were not finite and count as black\n"),
            std::string::npos)
      << run.err;
}

TEST_F(ChartCommand, RefusesAFolderOfOtherSettings) {
  ASSERT_EQ(chart().exit_code, 0);
  const std::string before = at_.bytes("c/runs.csv");
  for (const Names& other : {Names{"--max-depth=2"}, Names{"--width=13"}, Names{"--line-rays=2"},
                             Names{"--sampler=independent"}, Names{"--reference-time=0.02"}}) {
    const RunResult run = chart(other);
    EXPECT_EQ(run.exit_code, 3) << other[0];
    EXPECT_NE(run.err.find("c/settings.json: made with "), std::string::npos) << run.err;
  }
  EXPECT_EQ(at_.bytes("c/runs.csv"), before);
}

TEST_F(ChartCommand, KeepsFinishedRunsWhenInterrupted) {
  RunOptions options;
  options.folder = at_.folder.path();
  options.signal = SIGINT;
  options.signal_when = "\"progress\":0.";
  const Names slow = arguments({"--spp=1,2,100000", "--progress=jsonl"});
  const RunResult run = run_program(slow, options);
  EXPECT_EQ(run.exit_code, 130) << run.err;
  EXPECT_FALSE(run.killed);
  EXPECT_NE(run.err.find("stopped: finished runs are kept; repeat the command to continue\n"),
            std::string::npos)
      << run.err;
  EXPECT_FALSE(exists("c/summary.json"));
  EXPECT_EQ(lines_of(at_.bytes("c/runs.csv")), 1 + pictures());
  EXPECT_GE(pictures(), 4u);
  const RunResult rest = chart();
  EXPECT_EQ(rest.exit_code, 0);
  EXPECT_NE(rest.err.find("18 runs, 4 of them finished before"), std::string::npos) << rest.err;
}

TEST_F(ChartCommand, TakesAFileAsReference) {
  ASSERT_EQ(at_.render({"--width=12", "--height=12", "--max-depth=1", "--spp=64", "-o", "r.exr"})
                .exit_code,
            0);
  const RunResult run = chart({"--reference=r.exr"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("warning: the reference's own noise is not known"), std::string::npos);
  const nlohmann::json j = at_.json("c/summary.json");
  EXPECT_TRUE(j["noise_floor"].is_null());
  EXPECT_TRUE(j["methods"][0]["bias"].is_null());
  EXPECT_LT(j["methods"][0]["fit_over_spp"]["slope"], -0.5);
  // The empty fields of an unknown floor survive a second reading.
  EXPECT_EQ(chart({"--reference=r.exr"}).exit_code, 0);
}

TEST_F(ChartCommand, TakesItsOwnReferenceAgain) {
  ASSERT_EQ(chart().exit_code, 0);
  std::string reference;
  for (const auto& entry : std::filesystem::directory_iterator(at_.folder / "c"))
    if (entry.path().filename().string().starts_with("reference_")) reference = entry.path();
  ASSERT_FALSE(reference.empty());
  const RunResult run = chart({"--reference=" + reference, "--out=d"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(at_.json("d/summary.json")["noise_floor"], at_.json("c/summary.json")["noise_floor"]);
}

TEST_F(ChartCommand, RefusesWhatIsNoReference) {
  ASSERT_EQ(at_.render({"--width=12", "--height=12", "--max-depth=1", "-o", "biased.exr",
                        "--light-sampling=line-ratio"})
                .exit_code,
            0);
  ASSERT_EQ(at_.render({"--max-depth=1", "-o", "small.exr"}).exit_code, 0);
  ASSERT_EQ(at_.render({"--width=12", "--height=12", "-o", "deep.exr"}).exit_code, 0);
  for (const auto& [file, reason] : {std::pair{"biased.exr", "its method line-ratio is biased"},
                                     {"small.exr", "its size is 12x8, not 12x12"},
                                     {"missing.exr", "missing.exr: "},
                                     {"deep.exr", "its maximal depth is unlimited, not 1"}}) {
    const RunResult run = chart({std::string("--reference=") + file});
    EXPECT_EQ(run.exit_code, 3) << file;
    EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
    EXPECT_FALSE(exists("c/settings.json"));
  }
}

TEST_F(ChartCommand, MasksChooseThePixels) {
  ASSERT_EQ(at_.render({"--width=12", "--height=12", "-o", "m.png", "--spp=1"}).exit_code, 0);
  EXPECT_EQ(chart({"--mask=m.png"}).exit_code, 0);
  EXPECT_NE(at_.json("c/summary.json")["mask"], "none");
  EXPECT_EQ(chart().exit_code, 3);  // the folder is that of the mask
  ASSERT_EQ(at_.render({"-o", "wrong.png", "--spp=1"}).exit_code, 0);
  const RunResult run = chart({"--mask=wrong.png", "--out=d"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("wrong.png: 12x8 pixels, but the pictures have 12x12"), std::string::npos);
}

TEST_F(ChartCommand, DrawsChartsWhereThereIsGnuplot) {
  const RunResult run = chart();
  const bool has_gnuplot = std::system("gnuplot --version >/dev/null 2>&1") == 0;
  for (const char* name :
       {"c/error_vs_time.svg", "c/error_vs_time.png", "c/error_vs_spp.svg", "c/error_vs_spp.png"}) {
    EXPECT_EQ(exists(name), has_gnuplot) << name;
    EXPECT_EQ(run.out.find(name) != std::string::npos, has_gnuplot) << name;
  }
}

TEST_F(ChartCommand, WithoutGnuplotAllElseIsWritten) {
  Names command{"/usr/bin/env", "PATH=/nowhere", RAYTRACING_PROGRAM};
  for (const std::string& argument : arguments({})) command.push_back(argument);
  RunOptions options;
  options.folder = at_.folder.path();
  const RunResult run = run_any(command, options);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("no charts drawn: gnuplot is missing (Debian: gnuplot-nox)"),
            std::string::npos)
      << run.err;
  EXPECT_TRUE(exists("c/chart.gp"));
  EXPECT_TRUE(exists("c/report.html"));
  EXPECT_FALSE(exists("c/error_vs_time.svg"));
}

TEST_F(ChartCommand, QuietSaysNothing) {
  const RunResult run = chart({"--quiet"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "");
}

TEST_F(ChartCommand, RefusesWrongOptions) {
  for (const auto& [options, message] : std::vector<std::pair<Names, std::string>>{
           {{"--methods=point,lime"}, ", not 'lime'; the nearest is line"},
           {{"--methods=line,line"}, "--methods: line is listed twice"},
           {{"--spp=1,,2"}, "--spp: '' is not an integer"},
           {{"--spp=0"}, "--spp: 0 is not between 1 and "},
           {{"--spp=2,2"}, "--spp: 2 is listed twice"},
           {{"--seeds=0"}, "--seeds: 0 is not between 1 and "},
           {{"--reference-time=nan"}, "--reference-time: "},
           {{"--out="}, "--out: needs a value"}}) {
    const RunResult run = chart(options);
    EXPECT_EQ(run.exit_code, 2) << options[0];
    EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    EXPECT_EQ(lines_of(run.err), 1u) << run.err;
  }
}

TEST_F(ChartCommand, AnUnwritableFolderIsAnOutputError) {
  at_.folder.write("file", "x");
  EXPECT_EQ(chart({"--out=file/c"}).exit_code, 4);
}

}  // namespace
}  // namespace raytracing
