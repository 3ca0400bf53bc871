// Each option has the effect that the help describes.

#include <gtest/gtest.h>

#include <sstream>

#include "raytracing/integrator/direct_method.h"
#include "support/cli_folder.h"
#include "support/oiio.h"

namespace raytracing {
namespace {

/// The pixels of the Cornell box with these options.
std::vector<float> pixels(std::vector<std::string> options) {
  const CliFolder folder;
  options.insert(options.end(), {"--quiet", "-o", "x.exr"});
  const RunResult run = folder.render(options);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return read_with_oiio(folder.folder / "x.exr").values;
}

double mean(const std::vector<float>& values) {
  double sum = 0;
  for (const float value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(Effects, SizeComesFromTheOptions) {
  const CliFolder folder;
  ASSERT_EQ(folder.render({"--width", "7", "--height", "5", "-o", "x.exr"}).exit_code, 0);
  const ReadImage image = read_with_oiio(folder.folder / "x.exr");
  EXPECT_EQ(image.spec.width, 7);
  EXPECT_EQ(image.spec.height, 5);
}

TEST(Effects, SettingsComeFromTheSceneUnlessGiven) {
  const CliFolder folder;
  folder.folder.write("s.toml",
                      "[film]\nwidth = 5\nheight = 4\n[camera]\norigin = [0,0,1]\n"
                      "target = [0,0,0]\n[render]\nspp = 3\nlight_sampling = \"point\"\n");
  ASSERT_EQ(folder.run({"s.toml", "--stats", "s.json"}).exit_code, 0);
  const nlohmann::json s = folder.json("s.json");
  EXPECT_EQ(s["width"], 5);
  EXPECT_EQ(s["height"], 4);
  EXPECT_EQ(s["spp"], 3);
  EXPECT_EQ(s["light_sampling"], "point");
  ASSERT_EQ(folder
                .run({"s.toml", "--stats", "s.json", "--width", "2", "--height", "6", "--spp", "9",
                      "--light-sampling", "solid-angle"})
                .exit_code,
            0);
  const nlohmann::json t = folder.json("s.json");
  EXPECT_EQ(t["width"], 2);
  EXPECT_EQ(t["height"], 6);
  EXPECT_EQ(t["spp"], 9);
  EXPECT_EQ(t["light_sampling"], "solid-angle");
}

TEST(Effects, SeedSamplerAndMethodChangeThePicture) {
  const std::vector<float> base = pixels({});
  EXPECT_EQ(base, pixels({})) << "the same command line, another picture";
  EXPECT_EQ(base, pixels({"--seed", "0"}));
  EXPECT_NE(base, pixels({"--seed", "1"}));
  EXPECT_NE(pixels({"--seed", "1"}), pixels({"--seed", "18446744073709551615"}));
  EXPECT_NE(base, pixels({"--sampler", "independent"}));
  EXPECT_EQ(base, pixels({"--reuse", "16"}));
  EXPECT_NE(base, pixels({"--reuse", "1"}));
  EXPECT_EQ(base, pixels({"--sampler", "sobol"}));
  EXPECT_NE(base, pixels({"--spp", "3"}));
  EXPECT_EQ(base, pixels({"--light-sampling", "point"}));
  for (const DirectMethod& method : direct_methods()) {
    if (method.name == "point") continue;
    EXPECT_NE(base, pixels({"--light-sampling", std::string(method.name)})) << method.name;
  }
}

TEST(Effects, LineRaysChangeOnlyTheMethodThatCountsThem) {
  EXPECT_EQ(pixels({"--line-rays", "1"}), pixels({"--line-rays", "9"}));
  const std::vector<std::string> few{"--light-sampling", "line-ratio", "--line-rays", "1"};
  const std::vector<std::string> many{"--light-sampling", "line-ratio", "--line-rays", "9"};
  EXPECT_NE(pixels(few), pixels(many));
}

TEST(Effects, EachReflectionAddsLight) {
  double last = 0;
  for (const char* depth : {"1", "2", "4"}) {
    const double now = mean(pixels({"--max-depth", depth, "--spp", "64"}));
    EXPECT_GT(now, 1.02 * last) << depth;
    last = now;
  }
  EXPECT_GT(mean(pixels({"--spp", "64"})), last);
}

TEST(Effects, ThreadsDoNotChangeABitOfThePicture) {
  const std::vector<std::string> big{"--width", "50", "--height",   "34",
                                     "--spp",   "33", "--variance", "--threads"};
  const auto with = [&](const char* threads) {
    std::vector<std::string> options = big;
    options.push_back(threads);
    return pixels(options);
  };
  const std::vector<float> one = with("1");
  for (const char* threads : {"2", "3", "16"}) EXPECT_EQ(one, with(threads)) << threads;
}

TEST(Effects, VarianceAddsLayers) {
  const CliFolder folder;
  ASSERT_EQ(folder.render({"-o", "a.exr"}).exit_code, 0);
  ASSERT_EQ(folder.render({"-o", "b.exr", "-o", "b.png", "--variance"}).exit_code, 0);
  const ReadImage a = read_with_oiio(folder.folder / "a.exr");
  const ReadImage b = read_with_oiio(folder.folder / "b.exr");
  EXPECT_EQ(a.spec.nchannels, 3);
  EXPECT_EQ(b.spec.nchannels, 6);
  EXPECT_EQ(read_with_oiio(folder.folder / "b.png").spec.nchannels, 3);
  double sum = 0;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 12; ++x)
      for (const char* c : {"R", "G", "B"}) {
        EXPECT_EQ(a.at(x, y, c), b.at(x, y, c));
        EXPECT_GE(b.at(x, y, std::string("variance.") + c), 0);
        sum += b.at(x, y, std::string("variance.") + c);
      }
  EXPECT_GT(sum, 0);
}

TEST(Effects, VarianceIsThatOfTheTwoSamples) {
  // At 2 spp: mean m = (a + b) / 2 and variance of the mean ((a - b) / 2)^2.
  const CliFolder folder;
  ASSERT_EQ(folder.render({"-o", "two.exr", "--variance"}).exit_code, 0);
  ASSERT_EQ(folder.render({"-o", "one.exr", "--spp", "1"}).exit_code, 0);
  const ReadImage two = read_with_oiio(folder.folder / "two.exr");
  const ReadImage one = read_with_oiio(folder.folder / "one.exr");
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 12; ++x) {
      const double half = double{two.at(x, y, "G")} - one.at(x, y, "G");
      EXPECT_NEAR(two.at(x, y, "variance.G"), half * half, 1e-5 * half * half + 1e-9);
    }
}

TEST(Effects, OneReplicateIsNoneAndMoreAreAnotherPicture) {
  const std::vector<float> base = pixels({"--spp", "8", "--variance"});
  EXPECT_EQ(base, pixels({"--spp", "8", "--variance", "--replicates", "1"}));
  EXPECT_NE(base, pixels({"--spp", "8", "--variance", "--replicates", "2"}));
}

TEST(Effects, VarianceOfReplicatesIsThatOfTheirMeans) {
  // With two replicates: mean m = (a + b) / 2 and variance of the mean ((a - b) / 2)^2. The first
  // replicate is the picture of half as many samples.
  const CliFolder folder;
  ASSERT_EQ(folder
                .render({"-o", "two.exr", "--variance", "--spp", "10", "--replicates", "2",
                         "--stats", "s.json"})
                .exit_code,
            0);
  ASSERT_EQ(folder.render({"-o", "one.exr", "--spp", "5"}).exit_code, 0);
  const ReadImage two = read_with_oiio(folder.folder / "two.exr");
  const ReadImage one = read_with_oiio(folder.folder / "one.exr");
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 12; ++x) {
      const double half = double{two.at(x, y, "G")} - one.at(x, y, "G");
      EXPECT_NEAR(two.at(x, y, "variance.G"), half * half, 1e-5 * half * half + 1e-9);
    }
  EXPECT_EQ(two.attribute("replicates"), "2");
  EXPECT_NE(two.attribute("variance_kind").find("replicates"), std::string::npos);
  EXPECT_NE(two.attribute("variance_kind").find("1 degrees of freedom"), std::string::npos);
  EXPECT_EQ(folder.json("s.json")["replicates"], 2);
  EXPECT_EQ(folder.json("s.json")["variance_kind"], two.attribute("variance_kind"));
}

TEST(Effects, HeaderSaysWhatTheVarianceIsWorth) {
  const CliFolder folder;
  const auto kind = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--quiet", "-o", "x.exr"});
    EXPECT_EQ(folder.render(options).exit_code, 0);
    return read_with_oiio(folder.folder / "x.exr").attribute("variance_kind");
  };
  EXPECT_EQ(kind({}), "");
  EXPECT_NE(kind({"--variance"}).find("too large"), std::string::npos);
  EXPECT_NE(kind({"--variance", "--spp", "1"}).find("unknown"), std::string::npos);
  EXPECT_EQ(read_with_oiio(folder.folder / "x.exr").at(3, 3, "variance.G"), INFINITY);
  EXPECT_NE(kind({"--variance", "--sampler", "independent"}).find("honest"), std::string::npos);
}

TEST(Effects, HeaderSaysWhetherPixelsAreIndependent) {
  const CliFolder folder;
  const auto correlation = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--quiet", "--variance", "-o", "x.exr", "--stats", "s.json"});
    EXPECT_EQ(folder.render(options).exit_code, 0);
    const auto text = read_with_oiio(folder.folder / "x.exr").attribute("pixel_correlation");
    EXPECT_EQ(folder.json("s.json")["pixel_correlation"], text);
    return text;
  };
  EXPECT_EQ(correlation({"--reuse", "1"}).substr(0, 5), "none:");
  EXPECT_EQ(correlation({"--reuse", "8", "--max-depth", "1"}).substr(0, 5), "none:");
  EXPECT_NE(correlation({"--reuse", "8"}).find("less than 16 apart"), std::string::npos);
}

TEST(Effects, ProgressLinesAreJsonAndNeverEndEarly) {
  const CliFolder folder;
  const RunResult run =
      folder.render({"--progress", "jsonl", "--width", "100", "--height", "100", "--spp", "128",
                     "--reuse", "1", "--threads", "1", "-o", "x.png"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "x.png\n");
  std::istringstream lines(run.err);
  std::vector<double> progress;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("{")) continue;
    const nlohmann::json j = nlohmann::json::parse(line);
    progress.push_back(j.at("progress"));
    EXPECT_GE(j.at("seconds"), 0);
    EXPECT_GE(j.at("seconds_left"), 0);
  }
  ASSERT_GE(progress.size(), 2u) << run.err;
  for (std::size_t i = 0; i + 1 < progress.size(); ++i) {
    EXPECT_LT(progress[i], 1);
    EXPECT_LE(progress[i], progress[i + 1]);
  }
  EXPECT_EQ(progress.back(), 1);
}

TEST(Effects, ProgressIsABarOrNothing) {
  const CliFolder folder;
  const std::string bar = folder.render({"--progress", "bar", "-o", "x.png"}).err;
  const std::string full = "\r[" + std::string(40, '#') + "] 100 %";
  EXPECT_NE(bar.find(full), std::string::npos) << bar;
  for (const char* style : {"none", "auto"}) {  // a pipe is no terminal
    const std::string err = folder.render({"--progress", style, "-o", "x.png"}).err;
    EXPECT_EQ(err.find('\r'), std::string::npos) << err;
    EXPECT_EQ(err.find('{'), std::string::npos) << err;
  }
}

TEST(Effects, QuietIsSilent) {
  const CliFolder folder;
  for (const char* progress : {"auto", "bar", "jsonl"}) {
    const RunResult run =
        folder.render({"--quiet", "--progress", progress, "-o", "x.exr", "--stats", "x.json"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, "");
  }
  EXPECT_NE(folder.render({"-o", "x.exr"}).err, "");
}

TEST(Effects, ReplayIsTheSampleOfThePicture) {
  const CliFolder folder;
  const std::vector<std::string> options{"--spp", "1", "--seed", "5", "--sampler", "independent"};
  std::vector<std::string> rendering = options;
  rendering.insert(rendering.end(), {"-o", "x.exr"});
  ASSERT_EQ(folder.render(rendering).exit_code, 0);
  const ReadImage image = read_with_oiio(folder.folder / "x.exr");
  int lit = 0;
  for (int x = 3; x < 9; ++x) {
    std::vector<std::string> replay = options;
    replay.insert(replay.end(), {"--quiet", "--replay", std::to_string(x) + ",5,0"});
    const RunResult run = folder.render(replay);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("\nvertex 1 at ("), std::string::npos) << run.out;
    float r = -1, g = -1, b = -1;
    const std::size_t at = run.out.find("\nradiance (");
    ASSERT_NE(at, std::string::npos) << run.out;
    ASSERT_EQ(std::sscanf(run.out.c_str() + at, "\nradiance (%f, %f, %f)", &r, &g, &b), 3);
    EXPECT_EQ(r, image.at(x, 5, "R"));
    EXPECT_EQ(g, image.at(x, 5, "G"));
    EXPECT_EQ(b, image.at(x, 5, "B"));
    lit += r > 0;
  }
  EXPECT_GT(lit, 1);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"x.exr"}) << "--replay writes no picture";
}

TEST(Effects, ReplayKnowsTheReplicates) {
  // Two replicates of one sample each: the picture is the mean of two replays.
  const CliFolder folder;
  ASSERT_EQ(folder.render({"--replicates", "2", "-o", "x.exr"}).exit_code, 0);
  const ReadImage image = read_with_oiio(folder.folder / "x.exr");
  int lit = 0;
  for (int x = 3; x < 9; ++x) {
    float sum = 0;
    for (const char* sample : {",5,0", ",5,1"}) {
      const RunResult run =
          folder.render({"--quiet", "--replicates", "2", "--replay", std::to_string(x) + sample});
      const std::size_t at = run.out.find("\nradiance (");
      ASSERT_NE(at, std::string::npos) << run.out;
      float r = -1;
      ASSERT_EQ(std::sscanf(run.out.c_str() + at, "\nradiance (%f", &r), 1);
      sum += r;
    }
    EXPECT_NEAR(image.at(x, 5, "R"), sum / 2, 1e-6f * sum);
    lit += sum > 0;
  }
  EXPECT_GT(lit, 1);
}

}  // namespace
}  // namespace raytracing
