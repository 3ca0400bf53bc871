// The subcommand stress: what it leaves behind, its exit codes, and what it refuses.

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include "raytracing/integrator/direct_method.h"
#include "support/cli_folder.h"

namespace raytracing {
namespace {

class StressCommand : public ::testing::Test {
 protected:
  RunResult stress(Names more) const {
    more.insert(more.begin(), {"stress", "--out=s"});
    return at_.run(more);
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(at_.folder / name); }
  CliFolder at_;
};

TEST_F(StressCommand, LeavesATableHeatMapsAndAPage) {
  const RunResult run = stress({"--case=scale", "--case=contact", "--seeds=1"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(lines_of(at_.bytes("s/stress.csv")), 1 + (7 + 6) * direct_methods().size());
  for (const char* name : {"s/stress.csv", "s/stress.dat", "s/stress.gp", "s/stress.html"}) {
    EXPECT_TRUE(exists(name)) << name;
    EXPECT_NE(run.out.find(std::string(name) + "\n"), std::string::npos) << name;
  }
  const bool has_gnuplot = std::system("gnuplot --version >/dev/null 2>&1") == 0;
  for (const char* name : {"s/stress.svg", "s/stress.png", "s/stress_occluder.svg",
                           "s/stress_occluder.png", "s/stress_scene.svg", "s/stress_scene.png"})
    EXPECT_EQ(exists(name), has_gnuplot) << name;
  EXPECT_NE(run.err.find("line-ratio: biased: contact at "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("noisy: relative RMSE of 64 samples above 0.1"), std::string::npos);
}

TEST_F(StressCommand, WithoutGnuplotAllElseIsWritten) {
  const Names command{"/usr/bin/env", "PATH=/nowhere",     RAYTRACING_PROGRAM, "stress",
                      "--out=s",      "--case=terminator", "--seeds=1",        "--methods=line"};
  RunOptions options;
  options.folder = at_.folder.path();
  const RunResult run = run_any(command, options);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("no heat maps drawn: gnuplot is missing (Debian: gnuplot-nox)"),
            std::string::npos)
      << run.err;
  EXPECT_TRUE(exists("s/stress.gp"));
  EXPECT_TRUE(exists("s/stress.html"));
  EXPECT_FALSE(exists("s/stress.svg"));
}

TEST_F(StressCommand, PlotsOfAnEarlierRunAreNamedAndKept) {
  for (const char* name : {"s/stress_light.svg", "s/stress_surface.png", "s/stress_old.svg"})
    at_.folder.write(name, "old");
  const Names run_without{"/usr/bin/env", "PATH=/nowhere",  RAYTRACING_PROGRAM,
                          "stress",       "--out=s",        "--case=terminator",
                          "--seeds=1",    "--methods=line", "--quiet"};
  RunOptions options;
  options.folder = at_.folder.path();
  const std::string err = run_any(run_without, options).err;
  EXPECT_NE(err.find("warning: s: left by an earlier run: stress_light.svg, stress_surface.png\n"),
            std::string::npos)
      << err;
  if (std::system("gnuplot --version >/dev/null 2>&1") == 0) {
    EXPECT_EQ(stress({"--case=terminator", "--seeds=1", "--methods=line", "--quiet"}).err,
              "warning: s: left by an earlier run: stress_light.svg\n");
  }
  EXPECT_EQ(at_.bytes("s/stress_light.svg"), "old");
}

TEST_F(StressCommand, ASignalEndsItWithoutResults) {
  RunOptions options;
  options.folder = at_.folder.path();
  options.signal = SIGINT;
  options.signal_when = "\"progress\":";
  const RunResult run = run_program(
      {"stress", "--out=s", "--case=terminator", "--seeds=40", "--threads=1", "--progress=jsonl"},
      options);
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_FALSE(run.killed);
  EXPECT_NE(run.err.find("stopped: nothing written\n"), std::string::npos) << run.err;
  EXPECT_TRUE(std::filesystem::is_empty(at_.folder / "s"));
}

// Ctrl-C reaches the whole process group; gnuplot continues.
TEST_F(StressCommand, ASignalToAllLeavesGnuplotAlone) {
  at_.folder.write("gnuplot",
                   "#!/bin/sh\nkill -INT -- -$PPID\nsleep 0.1\n"
                   "for name in stress stress_surface; do echo drawn >$name.svg; done\n");
  std::filesystem::permissions(at_.folder / "gnuplot", std::filesystem::perms::owner_all);
  const std::string path = "PATH=" + at_.folder.path() + ":/usr/bin:/bin";
  RunOptions options;
  options.folder = at_.folder.path();
  const RunResult run = run_any({"/usr/bin/setsid", "/usr/bin/env", path, RAYTRACING_PROGRAM,
                                 "stress", "--out=s", "--case=terminator", "--seeds=1"},
                                options);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(at_.bytes("s/stress_surface.svg"), "drawn\n");
  EXPECT_TRUE(exists("s/stress.html"));
}

TEST_F(StressCommand, QuietSaysNothing) {
  const RunResult run = stress({"--case=terminator", "--seeds=1", "--methods=line", "--quiet"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "");
}

TEST_F(StressCommand, HelpNamesTheCases) {
  const RunResult run = at_.run({"stress", "--help"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("  light-aspect"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("  many-lights"), std::string::npos);
}

TEST_F(StressCommand, RefusesWrongOptions) {
  for (const auto& [options, message] : std::vector<std::pair<Names, std::string>>{
           {{"--case=scales"}, ", not 'scales'; the nearest is scale"},
           {{"--methods=lime"}, ", not 'lime'; the nearest is line"},
           {{"--seeds=0"}, "--seeds: 0 is not between 1 and "},
           {{"--threads=0"}, "--threads: 0 is not between 1 and "},
           {{"more"}, "more: one argument too many"}}) {
    const RunResult run = stress(options);
    EXPECT_EQ(run.exit_code, 2) << options[0];
    EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    EXPECT_EQ(lines_of(run.err), 1u) << run.err;
  }
  EXPECT_EQ(at_.run({"stress"}).exit_code, 2);
}

TEST_F(StressCommand, AnUnwritableFolderIsAnOutputError) {
  at_.folder.write("file", "x");
  EXPECT_EQ(stress({"--out=file/c"}).exit_code, 2);  // named twice
  EXPECT_EQ(at_.run({"stress", "--out=file/c"}).exit_code, 4);
}

}  // namespace
}  // namespace raytracing
