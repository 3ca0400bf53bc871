// --layers, as users see it: channels, coordinates, help and messages.

#include "support/layers.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/cli_folder.h"
#include "support/oiio.h"

namespace raytracing {
namespace {

LayeredPicture read_layers(const std::string& path) {
  const ReadImage read = read_with_oiio(path);
  ImageData image;
  image.width = read.spec.width;
  image.height = read.spec.height;
  image.channels = read.spec.channelnames;
  image.values = read.values;
  return LayeredPicture(std::move(image));
}

/// The picture that these options write.
LayeredPicture picture(const CliFolder& folder, std::vector<std::string> options) {
  options.insert(options.end(), {"--quiet", "-o", "x.exr"});
  const RunResult run = folder.render(options);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return read_layers(folder.folder / "x.exr");
}

std::set<std::string> channels_with(const CliFolder& folder,
                                    const std::vector<std::string>& options) {
  const std::vector<std::string> channels = picture(folder, options).image.channels;
  return {channels.begin(), channels.end()};
}

TEST(LayersOption, ExrHasTheChannelsAskedForAndNoOthers) {
  const CliFolder folder;
  using Set = std::set<std::string>;
  EXPECT_EQ(channels_with(folder, {}), (Set{"R", "G", "B"}));
  EXPECT_EQ(channels_with(folder, {"--layers", "depth"}), (Set{"R", "G", "B", "depth.Z"}));
  EXPECT_EQ(channels_with(folder, {"--layers", "samples,normal", "--variance"}),
            (Set{"R", "G", "B", "samples", "normal.X", "normal.Y", "normal.Z", "variance.R",
                 "variance.G", "variance.B"}));
  std::string all;
  Set expected{"R", "G", "B"};
  for (const Layer& layer : layers()) {
    all += (all.empty() ? "" : ",") + std::string(layer.name);
    for (const std::string& channel : layer.channels()) expected.insert(channel);
  }
  EXPECT_EQ(channels_with(folder, {"--layers=" + all}), expected);
}

TEST(LayersOption, PicturesAreTheSameWithAndWithoutThem) {
  const CliFolder folder;
  const LayeredPicture bare = picture(folder, {"-o", "bare.png"});
  const LayeredPicture layered =
      picture(folder, {"-o", "x.png", "--layers", "albedo,direct,indirect,position"});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 12; ++x) EXPECT_EQ(bare.radiance(x, y), layered.radiance(x, y));
  EXPECT_EQ(read_image(folder.folder / "x.png").values,
            read_image(folder.folder / "bare.png").values);
}

TEST(LayersOption, VarianceIsASynonym) {
  const CliFolder folder;
  const LayeredPicture by_layers = picture(folder, {"--layers", "variance"});
  for (const std::vector<std::string>& options :
       {Names{"--variance"}, Names{"--variance", "--layers", "variance"}}) {
    const LayeredPicture other = picture(folder, options);
    EXPECT_EQ(other.image.channels, by_layers.image.channels);
    EXPECT_EQ(other.image.values, by_layers.image.values);
  }
}

// The Cornell Box, whose coordinates its makers measured: floor y = 0, back wall z = 559.2.
TEST(LayersOption, AreThoseOfTheCornellBox) {
  const CliFolder folder;
  const LayeredPicture cornell = picture(folder, {"--layers", "position,normal,depth,samples"});
  EXPECT_NEAR(cornell.at(6, 3, "position.Z"), 559.2, 1e-3);
  EXPECT_EQ(cornell.at3(6, 3, "normal", "XYZ"), DVec3(0, 0, -1));
  EXPECT_GT(cornell.at(6, 3, "depth.Z"), 800 + 559.2f) << "the camera is at z = -800";
  EXPECT_LT(cornell.at(6, 3, "depth.Z"), 800 + 559.2f + 10);
  EXPECT_EQ(cornell.at(0, 0, "depth.Z"), INFINITY) << "beside the box";
  EXPECT_EQ(cornell.at(0, 0, "samples"), 2);
}

// The program moves a far scene to the origin of coordinates.
TEST(LayersOption, PositionsAreThoseOfTheSceneFile) {
  const CliFolder folder;
  for (const DVec3& place : {DVec3(0, 0, 0), DVec3(1e6, -2e6, 3e6)}) {
    std::string model = "v 0 0 0\n";
    for (const DVec3& p : {DVec3(-4, -4, 0), DVec3(4, -4, 0), DVec3(4, 4, 0), DVec3(-4, 4, 0)})
      model += fmt::format("v {} {} {}\n", p.x + place.x, p.y + place.y, p.z + place.z);
    folder.folder.write("m.obj", model + "f 2 3 4 5\n");
    folder.folder.write("s.toml",
                        fmt::format("[camera]\norigin = [{0}, {1}, {2}]\ntarget = [{0}, {1}, {3}]\n"
                                    "[[models]]\nobj = 'm.obj'\n",
                                    place.x, place.y, place.z + 8, place.z));
    const RunResult run = folder.run({"s.toml", "--width=2", "--height=2", "--spp=16", "--quiet",
                                      "--layers", "position,depth", "-o", "s.exr"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const LayeredPicture seen = read_layers(folder.folder / "s.exr");
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 2; ++x) {
        // The middle of the pixel, to the rounding of the file's floats. Half the field of view is
        // 20 degrees.
        const double half = 8 * std::tan(std::acos(-1.0) / 9) / 2;
        const DVec3 p = place + half * DVec3(x == 0 ? -1 : 1, y == 0 ? 1 : -1, 0);
        EXPECT_LT(length(seen.at3(x, y, "position", "XYZ") - p), 0.3);
        EXPECT_EQ(seen.at(x, y, "position.Z"), place.z);
        EXPECT_NEAR(seen.at(x, y, "depth.Z"), std::hypot(8, half, half), 0.2);
      }
  }
}

// Direct light takes the same random numbers whatever comes after it.
TEST(LayersOption, CompareFindsThem) {
  const CliFolder folder;
  picture(folder, {"--layers", "direct,samples", "--reuse", "1", "-o", "deep.exr"});
  picture(folder, {"--max-depth", "1", "-o", "flat.exr"});
  const Names same{"compare", "deep.exr", "flat.exr", "--max-relmse", "0"};
  EXPECT_EQ(folder.run(same).exit_code, 1);
  Names direct = same;
  direct.insert(direct.end(), {"--layer", "direct"});
  const RunResult run = folder.run(direct);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
}

TEST(LayersOption, HelpDescribesEach) {
  const std::string help = CliFolder().run({"--help"}).out;
  const std::size_t list = help.find("\nLayers of EXR images:\n");
  ASSERT_NE(list, std::string::npos);
  for (const Layer& layer : layers()) {
    const std::string line = fmt::format("\n{:<12} {}", layer.name, layer.channels().front());
    EXPECT_NE(help.find(line, list), std::string::npos) << line;
  }
}

TEST(LayersOption, FaultsAreTold) {
  const CliFolder folder;
  const std::string any =
      "must be albedo, normal, depth, position, direct, indirect, variance or samples, not ";
  expect_one_line(folder.render({"--layers", "albedo,dept"}), 2,
                  "--layers: " + any + "'dept'; the nearest is depth");
  expect_one_line(folder.render({"--layers", "normal,normal"}), 2,
                  "--layers: normal is listed twice (--help lists all options)");
  EXPECT_EQ(folder.render({"--layers", "depth,"}).exit_code, 2);
  EXPECT_EQ(folder.render({"--layers", ""}).exit_code, 2);
  EXPECT_EQ(folder.render({"--layers"}).exit_code, 2);
  EXPECT_TRUE(folder.names().empty());
}

TEST(LayersOption, WithoutAnExrHaveNoEffect) {
  const CliFolder folder;
  const auto warning = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--quiet", "-o", "x.png"});
    return folder.render(options).err;
  };
  const std::string end = " has no effect: no output is an .exr file\n";
  EXPECT_EQ(warning({"--layers", "depth"}), "warning: --layers" + end);
  EXPECT_EQ(warning({"--variance"}), "warning: --variance" + end);
  EXPECT_EQ(warning({"--variance", "--layers", "depth"}), "warning: --layers" + end);
  EXPECT_EQ(warning({"--layers", "depth", "-o", "x.exr"}), "");
}

}  // namespace
}  // namespace raytracing
