// A scene's name without a directory is also looked up among the scenes that come with the program.

#include <gtest/gtest.h>

#include "support/cli_folder.h"

namespace raytracing {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kTiny{"--width=4", "--height=4", "--spp=1", "-o", "x.png"};

/// The program as it is installed: in <prefix>/bin, <prefix>/lib and <prefix>/share/raytracing.
class Installed : public ::testing::Test {
 protected:
  Installed() {
    const fs::path share = prefix_ / "share/raytracing", source = RAYTRACING_SOURCE_DIR;
    fs::create_directories(prefix_ / "bin");
    fs::create_directories(share);
    fs::copy(RAYTRACING_PROGRAM, program());
    fs::copy(fs::path(RAYTRACING_PROGRAM).parent_path() / "lib", prefix_ / "lib",
             fs::copy_options::recursive);
    fs::copy(source / "scenes", share / "scenes", fs::copy_options::recursive);
    fs::copy(source / "models", share / "models", fs::copy_options::recursive);
  }

  std::string program() const { return prefix_ / "bin/Raytracing"; }
  fs::path scene(const std::string& name) const {
    return prefix_ / ("share/raytracing/scenes/" + name);
  }
  RunResult run(Names arguments) const {
    RunOptions options;
    options.folder = at_.folder.path();
    arguments.insert(arguments.begin(), program());
    return run_any(arguments, options);
  }
  RunResult render(const std::string& name, const Names& more = {}) const {
    Names arguments{"--scene", name};
    arguments.insert(arguments.end(), kTiny.begin(), kTiny.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  CliFolder at_;
  TempDir prefix_;
};

TEST_F(Installed, ScenesAreFoundByName) {
  for (const std::string name : {"cornell", "cornell.toml"}) {
    const RunResult run = render(name, {"--stats", "s.json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(at_.json("s.json")["scene"], scene("cornell.toml").string());
    EXPECT_TRUE(run.err.starts_with(scene("cornell.toml").string() + ": ")) << run.err;
  }
  EXPECT_EQ(run({"cornell", "--width=4", "--height=4", "--spp=1"}).out, "cornell.png\n");
  const RunResult chart = run({"chart", "cornell", "--out=c", "--width=4", "--height=4", "--spp=1",
                               "--seeds=2", "--max-depth=1", "--reference-time=0.01", "--quiet"});
  EXPECT_EQ(chart.exit_code, 0) << chart.err;
}

// A link to the program, as in /usr/local/bin, leads to the same scenes.
TEST_F(Installed, AMissingModuleForImagesIsFoundBeforeRendering) {
  fs::remove_all(prefix_ / "lib");
  const RunResult missing = render("cornell", {"--quiet"});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_TRUE(missing.err.starts_with(
      "Raytracing: the module for images, lib/raytracing/openimageio.so, is neither in "))
      << missing.err;
  EXPECT_EQ(lines_of(missing.err), 1u) << missing.err;
  EXPECT_EQ(at_.names(), Names{});
  EXPECT_EQ(run({"--version"}).exit_code, 0);
}

TEST_F(Installed, AModuleThatCannotBeLoadedStopsTheRendering) {
  std::ofstream(prefix_ / "lib/raytracing/openimageio.so") << "no library";
  const RunResult broken = run({"--scene", "cornell", "--quiet", "--spp=1000000", "-o", "x.png"});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_TRUE(broken.err.starts_with("Raytracing: the module for images cannot be loaded: "))
      << broken.err;
  EXPECT_EQ(lines_of(broken.err), 1u) << broken.err;
  EXPECT_EQ(at_.names(), Names{});
}

TEST_F(Installed, ScenesAreFoundThroughALink) {
  fs::create_symlink(program(), at_.folder / "link");
  RunOptions options;
  options.folder = at_.folder.path();
  Names arguments{at_.folder / "link", "cornell"};
  arguments.insert(arguments.end(), kTiny.begin(), kTiny.end());
  EXPECT_EQ(run_any(arguments, options).exit_code, 0);
}

TEST_F(Installed, AFileInTheWorkingDirectoryComesFirst) {
  const std::string empty = "[camera]\norigin = [0,0,1]\ntarget = [0,0,0]\n";
  at_.folder.write("cornell.toml", empty);
  for (const std::string name : {"cornell", "cornell.toml", "./cornell.toml"})
    EXPECT_NE(render(name).err.find("no light"), std::string::npos) << name;
  at_.folder.write("cornell", empty + "x");
  EXPECT_EQ(render("cornell").exit_code, 3) << "the name as given comes before all others";
}

TEST_F(Installed, NamesWithADirectoryAreNotLookedUp) {
  expect_one_line(render("./cornell.toml"), 3, "./cornell.toml: No such file or directory");
  expect_one_line(render("scenes/cornell.toml"), 3,
                  "scenes/cornell.toml: No such file or directory");
}

TEST_F(Installed, TheErrorListsWhatWasLookedFor) {
  expect_one_line(
      render("nope.toml"), 3,
      "nope.toml: no such scene file; looked for nope.toml, " + scene("nope.toml").string());
  expect_one_line(render("nope"), 3,
                  "nope: no such scene file; looked for nope, nope.toml, " +
                      scene("nope.toml").string() + "; the nearest subcommand is compare");
  fs::remove_all(scene(""));
  EXPECT_EQ(render("cornell").exit_code, 3);
}

// Scenes that come with the program are inputs as others are: no output replaces one.
TEST_F(Installed, ScenesAreNotOverwritten) {
  expect_one_line(render("cornell", {"--quiet", "--stats", scene("cornell.toml").string()}), 2,
                  scene("cornell.toml").string() + ": would be overwritten: it is named twice");
}

TEST(BuildTree, ScenesOfTheSourceAreFoundByName) {
  if (!fs::equivalent(fs::path(RAYTRACING_PROGRAM).parent_path().parent_path(),
                      RAYTRACING_SOURCE_DIR))
    GTEST_SKIP() << "the build tree does not lie in the source tree";
  const CliFolder folder;
  Names arguments{"cornell"};
  arguments.insert(arguments.end(), kTiny.begin(), kTiny.end());
  const RunResult run = folder.run(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

}  // namespace
}  // namespace raytracing
