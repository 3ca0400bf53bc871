// SIGKILL at any moment: what stands under the output name is a complete picture, old or new.

#include <gtest/gtest.h>

#include <csignal>
#include <random>

#include "raytracing/io/image.h"
#include "support/cli_folder.h"

namespace raytracing {
namespace {

TEST(Killed, LeavesACompletePictureOrNone) {
  const CliFolder folder;
  const std::vector<std::string> arguments{kCornell,  "--width=160", "--height=160", "--spp=1",
                                           "--quiet", "-o",          "x.exr"};
  RunOptions options;
  options.folder = folder.folder.path();
  const double whole = run_program(arguments, options).seconds;
  std::filesystem::remove(folder.folder / "x.exr");
  std::mt19937 random(1);
  std::uniform_real_distribution<double> moment(0, 1.1 * whole);
  int killed = 0, kept = 0;
  for (int i = 0; i < 200; ++i) {
    options.signal = SIGKILL;
    options.signal_after = moment(random);
    const RunResult run = run_program(arguments, options);
    killed += run.killed;
    if (!std::filesystem::exists(folder.folder / "x.exr")) continue;
    ++kept;
    EXPECT_EQ(read_image(folder.folder / "x.exr").width, 160) << i;
    std::filesystem::remove(folder.folder / "x.exr");
  }
  EXPECT_GT(killed, 50);
  EXPECT_GT(kept, 2);
  // Nobody can remove the temporary file of a killed run; it is hidden and says whose it was.
  for (const std::string& name : folder.names()) EXPECT_TRUE(name.starts_with(".x.exr.")) << name;
}

}  // namespace
}  // namespace raytracing
