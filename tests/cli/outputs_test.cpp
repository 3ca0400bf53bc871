// What a good run leaves behind: pictures, their headers, statistics.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/cli_folder.h"
#include "support/oiio.h"

namespace raytracing {
namespace {

TEST(Outputs, DefaultNameIsTheScenesInTheWorkingDirectory) {
  const CliFolder folder;
  const RunResult run = folder.render({});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "cornell.png\n");
  EXPECT_EQ(folder.names(), Names{"cornell.png"});
  EXPECT_EQ(read_with_oiio(folder.folder / "cornell.png").spec.width, 12);
}

TEST(Outputs, AllAreWrittenAndNamedOnStdout) {
  const CliFolder folder;
  folder.folder.write("old.png", "not a picture");
  const RunResult run =
      folder.render({"-o", "a.exr", "--output", "b.PNG", "--output=old.png", "--stats", "s.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "a.exr\nb.PNG\nold.png\n");
  EXPECT_EQ(folder.names(), (Names{"a.exr", "b.PNG", "old.png", "s.json"}));
  EXPECT_EQ(folder.bytes("b.PNG").substr(1, 3), "PNG");
  EXPECT_EQ(read_with_oiio(folder.folder / "old.png").spec.width, 12);
}

TEST(Outputs, AllFormatsShowTheSamePicture) {
  const CliFolder folder;
  ASSERT_EQ(folder
                .render({"-o", "a.exr", "-o", "a.png", "-o", "a.tif", "-o", "a.hdr", "-o", "a.jpg",
                         "-o", "a.ppm"})
                .exit_code,
            0);
  ASSERT_EQ(folder.render({"--float", "-o", "f.tif", "-o", "f.png"}).exit_code, 0);
  const ReadImage exr = read_with_oiio(folder.folder / "a.exr");
  EXPECT_EQ(read_with_oiio(folder.folder / "f.tif").values, exr.values);
  EXPECT_EQ(read_with_oiio(folder.folder / "f.tif").spec.format, OIIO::TypeFloat);
  const ReadImage png = read_with_oiio(folder.folder / "a.png");
  for (const char* name : {"a.tif", "a.ppm", "f.png"})
    EXPECT_EQ(read_with_oiio(folder.folder / name).values, png.values) << name;
  const ReadImage hdr = read_with_oiio(folder.folder / "a.hdr");
  for (std::size_t i = 0; i < exr.values.size(); ++i)
    EXPECT_NEAR(hdr.values[i], exr.values[i],
                *std::max_element(exr.values.begin() + static_cast<std::ptrdiff_t>(i / 3 * 3),
                                  exr.values.begin() + static_cast<std::ptrdiff_t>(i / 3 * 3 + 3)) /
                    127);
  EXPECT_NE(
      read_with_oiio(folder.folder / "a.jpg").attribute("ImageDescription").find("scene_hash"),
      std::string::npos);
}

TEST(Outputs, OneThatCannotBeMadeDoesNotLoseTheOthers) {
  const CliFolder folder;
  const RunResult run = folder.render(
      {"--width", "65536", "--height", "1", "-o", "a.jpg", "-o", "a.exr", "--stats", "a.json"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_NE(run.err.find("Raytracing: JPEG images have at most 65500 pixels a side\n"),
            std::string::npos)
      << run.err;
  EXPECT_EQ(folder.names(), (Names{"a.exr", "a.json"}));
}

TEST(Outputs, FormatsWithoutFactsAreTold) {
  const CliFolder folder;
  EXPECT_NE(folder.render({"-o", "a.hdr"})
                .err.find("warning: a.hdr: .hdr files cannot carry the facts of the rendering\n"),
            std::string::npos);
}

TEST(Outputs, FloatWithoutATiffIsTold) {
  const CliFolder folder;
  EXPECT_NE(folder.render({"--float", "-o", "a.png"})
                .err.find("warning: --float has no effect: no output is a .tif file\n"),
            std::string::npos);
}

TEST(Outputs, StatisticsHaveAllKeysWithSaneValues) {
  const CliFolder folder;
  ASSERT_EQ(folder
                .render({"--stats", "s.json", "-o", "x.exr", "--seed", "18446744073709551615",
                         "--threads", "2", "--max-depth", "3", "--width", "40", "--reuse", "1"})
                .exit_code,
            0);
  const nlohmann::json s = folder.json("s.json");
  const std::set<std::string> contract{"scene",         "light_sampling", "sampler",
                                       "spp",           "width",          "height",
                                       "max_depth",     "seed",           "threads",
                                       "load_seconds",  "build_seconds",  "render_seconds",
                                       "cpu_seconds",   "paths",          "paths_per_second",
                                       "rays_closest",  "rays_shadow",    "segment_queries",
                                       "shaft_queries", "peak_rss_bytes", "non_finite_samples",
                                       "mean_r",        "mean_g",         "mean_b",
                                       "replicates",    "variance_kind"};
  for (const std::string& key : contract) EXPECT_TRUE(s.contains(key)) << key;
  EXPECT_EQ(s["scene"], kCornell);
  EXPECT_EQ(s["light_sampling"], "point");
  EXPECT_EQ(s["sampler"], "sobol");
  EXPECT_EQ(s["spp"], 2);
  EXPECT_EQ(s["width"], 40);
  EXPECT_EQ(s["height"], 8);
  EXPECT_EQ(s["max_depth"], 3);
  EXPECT_EQ(s["seed"], 18446744073709551615u);
  EXPECT_EQ(s["threads"], 2);
  const double paths = 40 * 8 * 2;
  EXPECT_EQ(s["paths"], paths);
  const double seconds = s["render_seconds"];
  EXPECT_GT(seconds, 0);
  EXPECT_LT(seconds, 60);
  EXPECT_NEAR(s["paths_per_second"].get<double>() * seconds, paths, 1e-6 * paths);
  EXPECT_GT(s["load_seconds"], 0);
  EXPECT_GT(s["build_seconds"], 0);
  EXPECT_GT(s["cpu_seconds"], 0);
  EXPECT_GE(s["rays_closest"], paths);
  EXPECT_LE(s["rays_closest"], 3 * paths);
  EXPECT_GT(s["rays_shadow"], 0);
  EXPECT_LE(s["rays_shadow"], s["rays_closest"]);
  EXPECT_EQ(s["segment_queries"], 0);
  EXPECT_EQ(s["shaft_queries"], 0);
  EXPECT_GT(s["peak_rss_bytes"], 1e6);
  EXPECT_EQ(s["non_finite_samples"], 0);
  const ReadImage image = read_with_oiio(folder.folder / "x.exr");
  for (int c = 0; c < 3; ++c) {
    double sum = 0;
    for (std::size_t i = static_cast<std::size_t>(c); i < image.values.size(); i += 3)
      sum += image.values[i];
    EXPECT_NEAR(s[std::string("mean_") + "rgb"[c]], sum / (40 * 8), 1e-5 * sum);
  }
}

TEST(Outputs, UnlimitedDepthIsStated) {
  const CliFolder folder;
  ASSERT_EQ(folder.render({"--stats", "s.json"}).exit_code, 0);
  EXPECT_EQ(folder.json("s.json")["max_depth"], "unlimited");
}

TEST(Outputs, HeadersSayHowThePictureWasMade) {
  const CliFolder folder;
  ASSERT_EQ(
      folder
          .render({"-o", "it's.exr", "-o", "x.png", "--seed", "42", "--threads", "2", "--max-depth",
                   "3", "--light-sampling", "line-ratio", "--sampler", "independent"})
          .exit_code,
      0);
  const std::string command = "Raytracing " + kCornell +
                              " --width=12 --height=8 --spp=2 -o 'it'\\''s.exr' -o x.png --seed 42"
                              " --threads 2 --max-depth 3 --light-sampling line-ratio"
                              " --sampler independent";
  for (const char* name : {"it's.exr", "x.png"}) {
    const ReadImage image = read_with_oiio(folder.folder / name);
    const auto text = [&](const char* key) { return image.attribute(key); };
    EXPECT_TRUE(text("software").starts_with("Raytracing ") ||
                text("Software").starts_with("Raytracing "))
        << name;
    EXPECT_NE(text("build"), "") << name;
    EXPECT_EQ(text("command"), command);
    EXPECT_EQ(text("scene"), kCornell);
    EXPECT_EQ(text("scene_hash").size(), 16u);
    EXPECT_EQ(text("seed"), "42");
    EXPECT_EQ(text("spp"), "2");
    EXPECT_EQ(text("sampler"), "independent");
    EXPECT_EQ(text("light_sampling"), "line-ratio");
    EXPECT_EQ(text("light_sampling_biased"), "true");
    EXPECT_EQ(text("max_depth"), "3");
    EXPECT_EQ(text("threads"), "2");
    EXPECT_GT(std::stod(text("render_seconds")), 0);
    EXPECT_EQ(text("non_finite_samples"), "0");
    EXPECT_EQ(text("complete"), "true");
  }
}

TEST(Outputs, TheLargestSeedKeepsItsDigitsInTheHeader) {
  const CliFolder folder;
  ASSERT_EQ(folder.render({"-o", "x.exr", "--seed", "18446744073709551615"}).exit_code, 0);
  const ReadImage image = read_with_oiio(folder.folder / "x.exr");
  EXPECT_EQ(image.attribute("seed"), "18446744073709551615");
  EXPECT_EQ(image.attribute("light_sampling_biased"), "false");
}

TEST(Outputs, TheSceneHashCoversTheModels) {
  const CliFolder folder;
  const auto hash = [&](const char* kd) {
    folder.folder.write("m.mtl", std::string("newmtl a\nKd ") + kd + "\n");
    folder.folder.write("m.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.folder.write("s.toml",
                        "[film]\nwidth = 2\nheight = 2\n[camera]\norigin = [0,0,1]\n"
                        "target = [0,0,0]\n[[models]]\nobj = 'm.obj'\n");
    EXPECT_EQ(folder.run({"s.toml", "-o", "x.exr"}).exit_code, 0);
    return read_with_oiio(folder.folder / "x.exr").attribute("scene_hash");
  };
  const std::string first = hash("0.5 0.5 0.5");
  EXPECT_EQ(first, hash("0.5 0.5 0.5"));
  EXPECT_NE(first, hash("0.5 0.5 0.6"));
}

TEST(Outputs, AnEmptySceneIsBlackWithAWarning) {
  const CliFolder folder;
  folder.folder.write("empty.toml",
                      "[film]\nwidth = 4\nheight = 3\n[camera]\norigin = [0,0,1]\n"
                      "target = [0,0,0]\n");
  const RunResult run = folder.run({"empty.toml", "--quiet", "-o", "x.exr"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "warning: the scene has no light; the image will be black\n");
  EXPECT_EQ(read_with_oiio(folder.folder / "x.exr").values, std::vector<float>(4 * 3 * 3, 0.0f));
}

TEST(Outputs, ASceneWithoutLightIsBlackWithAWarning) {
  const CliFolder folder;
  folder.folder.write("m.obj", "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 1 2 3\n");
  folder.folder.write("dark.toml",
                      "[film]\nwidth = 4\nheight = 3\n[camera]\norigin = [0,0,1]\n"
                      "target = [0,0,0]\n[[models]]\nobj = 'm.obj'\n");
  const RunResult run = folder.run({"dark.toml", "-o", "x.exr"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("warning: the scene has no light; the image will be black\n"),
            std::string::npos);
  EXPECT_EQ(read_with_oiio(folder.folder / "x.exr").values, std::vector<float>(4 * 3 * 3, 0.0f));
}

}  // namespace
}  // namespace raytracing
