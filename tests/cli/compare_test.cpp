// The subcommand compare: its numbers and the files it writes.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <sstream>

#include "raytracing/io/image.h"
#include "raytracing/io/srgb.h"
#include "raytracing/study/metrics/error_metrics.h"
#include "raytracing/study/metrics/error_picture.h"
#include "raytracing/study/metrics/flip.h"
#include "support/compare_folder.h"

namespace raytracing {
namespace {

TEST(Compare, PrintsNumbersWithTheirFormulas) {
  const OneChannelOff folder;
  const RunResult run = folder.compare({"a.exr", "b.exr"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
  for (const char* line :
       {"x = a.exr\nr = b.exr\nmeans over R, G and B of 2 pixels\n",
        "\nMSE               0.0416667  mean (x-r)^2\n",
        "\nRMSE               0.204124  sqrt(MSE)\n",
        "\nrelMSE            0.0412541  mean (x-r)^2 / (r^2 + 0.01)\n",
        "\nMAE               0.0833333  mean |x-r|\n",
        "\nPSNR                13.8021  10 log10(1 / MSE) dB, for a peak of 1\n",
        "\nSMAPE             0.0551876  mean |x-r| / (|x| + |r| + 0.01)\n", "\nFLIP ",
        "  mean LDR-FLIP, 67 pixels per degree, values clamped to 0..1, NaN to 0\n",
        "\nmean ratio G              1  mean x / mean r\n",
        "\nmean ratio B           0.75  mean x / mean r\n",
        "\nlargest                 0.5  |x-r| of a channel, at pixel 1,0\n",
        "\nnon-finite x              0  pixels, excluded from the means\n"})
    EXPECT_NE(run.out.find(line), std::string::npos) << line << "\n" << run.out;
  EXPECT_EQ(run.out.find("|z|"), std::string::npos);
  EXPECT_EQ(folder.names(), (Names{"a.exr", "b.exr"}));
}

TEST(Compare, JsonSaysTheSame) {
  const CompareFolder folder;
  const ImageData a = random_picture(9, 7, 1), b = random_picture(9, 7, 2);
  folder.write("a.exr", a);
  folder.write("b.exr", b);
  const RunResult run = folder.compare({"a.exr", "b.exr", "--json", "c.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json j = folder.json("c.json");
  const ErrorMetrics m = error_metrics(a, b);
  EXPECT_EQ(j["test"], "a.exr");
  EXPECT_EQ(j["reference"], "b.exr");
  EXPECT_EQ(j["pixels"], 63);
  EXPECT_EQ(j["epsilon"], 0.01);
  EXPECT_EQ(j["mse"], m.mse);
  EXPECT_EQ(j["rmse"], m.rmse);
  EXPECT_EQ(j["relmse"], m.relmse);
  EXPECT_EQ(j["mae"], m.mae);
  EXPECT_EQ(j["psnr"], m.psnr);
  EXPECT_EQ(j["smape"], m.smape);
  EXPECT_EQ(j["flip"], masked_mean(flip_map(a, b)));
  EXPECT_EQ(j["mean_ratio_r"], m.mean_ratio.x);
  EXPECT_EQ(j["mean_ratio_g"], m.mean_ratio.y);
  EXPECT_EQ(j["mean_ratio_b"], m.mean_ratio.z);
  EXPECT_EQ(j["largest"], m.largest);
  EXPECT_EQ(j["largest_pixel"], (nlohmann::json{m.largest_x, m.largest_y}));
  EXPECT_EQ(j["non_finite_test"], 0);
  EXPECT_EQ(j["non_finite_reference"], 0);
  EXPECT_FALSE(j.contains("z_rms"));
  // Each line of the table is a number of the JSON with its formula.
  for (const auto& [key, formula] : j["formulas"].items()) {
    EXPECT_TRUE(j.contains(key)) << key;
    EXPECT_NE(run.out.find(formula.get<std::string>()), std::string::npos) << key;
  }
  EXPECT_EQ(j["formulas"].size() + 3, lines_of(run.out));
}

TEST(Compare, EqualPicturesHaveNoError) {
  const OneChannelOff folder;
  const RunResult run = folder.compare({"a.exr", "a.exr", "--max-relmse", "0", "--json", "c.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("\nPSNR                    inf  "), std::string::npos) << run.out;
  EXPECT_TRUE(folder.json("c.json")["psnr"].is_null());
  EXPECT_EQ(folder.json("c.json")["flip"], 0);
}

TEST(Compare, TheMaskDecidesWhatCounts) {
  const OneChannelOff folder;
  folder.write("first.png", rgb_picture(2, 1, {1, 1, 1, 0, 0, 0}));
  folder.write("second.exr", rgb_picture(2, 1, {0, 0, 0, 1, 1, 1}));
  const auto relmse = [&](const std::string& mask) {
    EXPECT_EQ(folder.compare({"a.exr", "b.exr", "--mask", mask, "--json", "j"}).exit_code, 0);
    return folder.json("j")["relmse"].get<double>();
  };
  EXPECT_EQ(relmse("first.png"), 0);
  EXPECT_DOUBLE_EQ(relmse("second.exr"), 0.25 / 1.01 / 3);
}

// Half a code at the steepest place of the curve: 2.4 / 1.055 / 255 / 2.
TEST(Compare, PngDiffersFromExrByQuantisationOnly) {
  const CompareFolder folder;
  const ImageData image = random_picture(64, 48, 3);
  folder.write("a.png", image);
  folder.write("b.exr", image);
  const RunResult run = folder.compare({"a.png", "b.exr", "--json", "j"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "note: a.png: 8 bits per channel; values above 1 are clipped\n");
  const nlohmann::json j = folder.json("j");
  EXPECT_LT(j["largest"], 0.004461);
  EXPECT_GT(j["largest"], 0.004);
  EXPECT_LT(j["relmse"], 5e-5);
  EXPECT_LT(j["flip"], 0.01);
  for (const char* ratio : {"mean_ratio_r", "mean_ratio_g", "mean_ratio_b"})
    EXPECT_NEAR(j[ratio].get<double>(), 1, 1e-3);
}

TEST(Compare, TakesGreyPictures) {
  const CompareFolder folder;
  const auto output = OIIO::ImageOutput::create(folder.folder / "grey.png");
  const std::vector<std::uint8_t> codes = {0, 255};
  ASSERT_TRUE(output->open(folder.folder / "grey.png", {2, 1, 1, OIIO::TypeDesc::UINT8}));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, codes.data()));
  output->close();
  folder.write("b.exr", rgb_picture(2, 1, {0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(folder.compare({"grey.png", "b.exr", "--max-relmse", "0"}).exit_code, 0);
}

TEST(Compare, WritesTheErrorPicture) {
  const CompareFolder folder;
  const ImageData a = random_picture(200, 30, 4), b = random_picture(200, 30, 5);
  folder.write("a.exr", a);
  folder.write("b.exr", b);
  const ImageData expected = error_picture(a, b);
  for (const char* name : {"d.png", "d.exr"}) {
    ASSERT_EQ(folder.compare({"a.exr", "b.exr", "--diff", name}).exit_code, 0);
    const ImageData diff = read_image(folder.folder / name);
    EXPECT_EQ(diff.width, 200);
    EXPECT_GT(diff.height, 30);
    ASSERT_EQ(diff.values.size(), expected.values.size());
    for (std::size_t i = 0; i < diff.values.size(); ++i)
      ASSERT_EQ(srgb8(diff.values[i]), srgb8(expected.values[i])) << name;
  }
}

// Two renderings with independent samples. The bounds are wide, for the mean of a pixel's 64
// samples is not normal yet, and there are few pixels.
TEST(Compare, VarianceLayersGiveZScores) {
  const CompareFolder folder;
  for (const auto& [name, seed] : {std::pair{"a.exr", "1"}, {"b.exr", "2"}})
    ASSERT_EQ(folder
                  .render({"--sampler", "independent", "--spp", "64", "--seed", seed, "--variance",
                           "--reuse", "1", "-o", name})
                  .exit_code,
              0);
  const RunResult run = folder.compare({"a.exr", "b.exr", "--json", "j", "--z-scores", "z.exr"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(read_image(folder.folder / "z.exr").values.size(), 12u * 8 * 3);
  EXPECT_NE(run.out.find("\n|z| > 1.96 "), std::string::npos) << run.out;
  const nlohmann::json j = folder.json("j");
  EXPECT_GT(j["z_rms"], 0.7);
  EXPECT_LT(j["z_rms"], 1.4);
  EXPECT_LT(j["z_share_1.96"], 0.15);
  EXPECT_EQ(j["z_scores"].get<int>() + j["z_no_variance_equal"].get<int>() +
                j["z_no_variance_different"].get<int>(),
            12 * 8 * 3);
}

TEST(Compare, HelpNamesEveryOption) {
  const RunResult help = CompareFolder().compare({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* option : {"\n  A FILE ", "\n  B FILE ", "\n  --mask FILE ", "\n  --diff FILE ",
                             "\n  --max-relmse X ", "\n  --json FILE ", "Exit codes: 0 success"})
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  std::istringstream lines(help.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  EXPECT_NE(CompareFolder().run({"--help"}).out.find("\ncompare "), std::string::npos);
}

}  // namespace
}  // namespace raytracing
