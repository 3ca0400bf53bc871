// SIGINT and SIGTERM end a rendering early and keep what was computed.

#include <gtest/gtest.h>

#include <csignal>

#include "support/cli_folder.h"
#include "support/oiio.h"

namespace raytracing {
namespace {

/// Starts a rendering of many minutes and sends it a signal once it shows progress.
RunResult interrupted(const CliFolder& folder, int signal, int count = 1) {
  RunOptions options;
  options.folder = folder.folder.path();
  options.signal = signal;
  options.signal_count = count;
  options.signal_when = "\"progress\":";
  return run_program({kCornell, "--width=64", "--height=64", "--spp=1000000", "--progress=jsonl",
                      "-o", "x.exr", "-o", "x.png", "-o", "x.tif", "--stats", "x.json"},
                     options);
}

void expect_partial_picture(const CliFolder& folder, const RunResult& run) {
  EXPECT_FALSE(run.killed) << run.err;
  EXPECT_LT(run.seconds, 30);
  EXPECT_EQ(run.out, "x.exr\nx.png\nx.tif\n");
  EXPECT_NE(run.err.find(" samples taken; the image is incomplete\n"), std::string::npos);
  EXPECT_EQ(run.err.find("\"progress\":1"), std::string::npos) << run.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"x.exr", "x.json", "x.png", "x.tif"}));
  const ReadImage image = read_with_oiio(folder.folder / "x.exr");
  EXPECT_EQ(image.attribute("complete"), "false");
  float brightest = 0;
  for (const float value : image.values) brightest = std::max(brightest, value);
  EXPECT_GT(brightest, 0);
  EXPECT_EQ(read_with_oiio(folder.folder / "x.png").attribute("complete"), "false");
  const std::string facts = read_with_oiio(folder.folder / "x.tif").attribute("ImageDescription");
  EXPECT_NE(facts.find("\ncomplete: false\n"), std::string::npos) << facts;
  const nlohmann::json stats = folder.json("x.json");
  EXPECT_EQ(stats["complete"], false);
  EXPECT_GT(stats["paths"], 0);
  EXPECT_LT(stats["paths"], 64ll * 64 * 1000000);
}

TEST(Interrupt, SigintKeepsThePicture) {
  const CliFolder folder;
  const RunResult run = interrupted(folder, SIGINT);
  EXPECT_EQ(run.exit_code, 130);
  expect_partial_picture(folder, run);
}

TEST(Interrupt, SigtermKeepsThePicture) {
  const CliFolder folder;
  const RunResult run = interrupted(folder, SIGTERM);
  EXPECT_EQ(run.exit_code, 143);
  expect_partial_picture(folder, run);
}

TEST(Interrupt, ASignalSentTwiceAtOnceIsOne) {
  // timeout(1) signals the process and then its process group.
  for (int i = 0; i < 3; ++i) {
    const CliFolder folder;
    const RunResult run = interrupted(folder, SIGTERM, 2);
    EXPECT_EQ(run.exit_code, 143);
    expect_partial_picture(folder, run);
  }
}

TEST(Interrupt, AnyMomentLeavesEitherAllOrNothing) {
  const CliFolder folder;
  folder.folder.write("x.png", "the old picture");
  for (int i = 0; i < 25; ++i) {
    RunOptions options;
    options.folder = folder.folder.path();
    options.signal = SIGTERM;
    options.signal_after = 0.002 * i;
    const RunResult run = run_program({kCornell, "--spp=100000", "-o", "x.png"}, options);
    EXPECT_EQ(run.exit_code, 143);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"x.png"}) << i << run.err;
    if (run.out.empty()) {
      EXPECT_EQ(folder.bytes("x.png"), "the old picture") << i;
    } else {
      EXPECT_EQ(read_with_oiio(folder.folder / "x.png").attribute("complete"), "false");
      folder.folder.write("x.png", "the old picture");
    }
  }
}

// Encoding and writing take most of this run, so that some signals arrive during them.
TEST(Interrupt, SignalsWhileWritingLeaveWholePictures) {
  const CliFolder folder;
  RunOptions options;
  options.folder = folder.folder.path();
  const std::vector<std::string> arguments{kCornell,        "--spp=1",       "--width=300",
                                           "--height=300",  "--max-depth=1", "--output=x.exr",
                                           "--output=x.png"};
  const RunResult whole = run_program(arguments, options);
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  options.signal = SIGTERM;
  for (int i = 0; i < 6; ++i) {
    for (const char* name : {"x.exr", "x.png"}) folder.folder.write(name, "old");
    options.signal_after = whole.seconds * (0.5 + 0.08 * i);
    const RunResult run = run_program(arguments, options);
    EXPECT_TRUE(run.exit_code == 143 || run.exit_code == 0) << run.exit_code << run.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"x.exr", "x.png"})) << run.err;
    for (const char* name : {"x.exr", "x.png"}) {
      const bool written = run.out.find(name) != std::string::npos;
      EXPECT_EQ(folder.bytes(name) != "old", written) << name;
      if (written) {
        EXPECT_EQ(read_with_oiio(folder.folder / name).values.size(), 3u * 300 * 300);
      }
    }
  }
}

// The PNG file takes so long to encode that the signal arrives before the program ends.
TEST(Interrupt, ASignalAfterTheLastSampleKeepsTheResult) {
  const CliFolder folder;
  folder.write_overflowing_scene();
  RunOptions options;
  options.folder = folder.folder.path();
  const RunResult run =
      run_any({"/bin/sh", "-c",
               std::string(RAYTRACING_PROGRAM) +
                   " s.toml --strict --quiet --spp 1 --reuse 1 --width 1500 --height 1500 -o x.exr "
                   "-o x.png & while ! test -e x.exr; do sleep .01; done; kill -TERM $!; wait $!"},
              options);
  EXPECT_EQ(run.exit_code, 1) << run.err;  // the one of --strict
  EXPECT_NE(run.err.find(" samples were not finite"), std::string::npos) << run.err;
  EXPECT_EQ(read_with_oiio(folder.folder / "x.png").attribute("complete"), "true");
}

TEST(Interrupt, ACompletePictureSaysSo) {
  const CliFolder folder;
  ASSERT_EQ(folder.render({"-o", "x.exr", "--stats", "x.json"}).exit_code, 0);
  EXPECT_EQ(read_with_oiio(folder.folder / "x.exr").attribute("complete"), "true");
  EXPECT_EQ(folder.json("x.json")["complete"], true);
}

}  // namespace
}  // namespace raytracing
