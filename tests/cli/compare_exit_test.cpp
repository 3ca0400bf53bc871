// The subcommand compare: its exit codes, and what it says on stderr.

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "support/compare_folder.h"

namespace raytracing {
namespace {

TEST(CompareExit, TheLimitDecidesTheExitCode) {
  const OneChannelOff folder;
  EXPECT_EQ(folder.compare({"a.exr", "b.exr", "--max-relmse", "0.0413"}).exit_code, 0);
  const RunResult above = folder.compare({"a.exr", "b.exr", "--max-relmse=.0412", "--json", "j"});
  EXPECT_EQ(above.exit_code, 1);
  EXPECT_EQ(above.err, "Raytracing: relMSE 0.0412541 exceeds --max-relmse 0.0412\n");
  EXPECT_NE(above.out.find("relMSE "), std::string::npos);
  EXPECT_EQ(folder.names(), (Names{"a.exr", "b.exr", "j"}));
}

TEST(CompareExit, NonFinitePixelsAreReportedAndNotWithinAnyLimit) {
  const CompareFolder folder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  folder.write("a.exr", rgb_picture(3, 1, {1, 1, 1, nan, 1, 1, 1, 1, 1}));
  folder.write("b.exr", rgb_picture(3, 1, {1, 1, 1, 1, 1, 1, 1, 1, -1 / 0.0f}));
  const RunResult run = folder.compare({"a.exr", "b.exr", "--diff", "d.png"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("R, G and B of 1 pixels\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("non-finite x              1"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("non-finite r              1"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("relMSE                    0"), std::string::npos) << run.out;
  const RunResult limit = folder.compare({"a.exr", "b.exr", "--max-relmse", "1e30"});
  EXPECT_EQ(limit.exit_code, 1);
  EXPECT_EQ(limit.err, "Raytracing: 1 pixels are not finite\n");
  EXPECT_EQ(folder.compare({"b.exr", "b.exr", "--max-relmse", "1"}).exit_code, 1);
}

TEST(CompareExit, NothingIsOverwrittenByAnother) {
  const OneChannelOff folder;
  expect_one_line(folder.compare({"a.exr", "b.exr", "--diff", "./a.exr"}), 2,
                  "./a.exr: would be overwritten: it is named twice");
  expect_one_line(folder.compare({"a.exr", "b.exr", "--diff", "d.png", "--json", "d.png"}), 2,
                  "d.png: would be overwritten: it is named twice");
  EXPECT_EQ(folder.names(), (Names{"a.exr", "b.exr"}));
}

// Without a pixel to measure there is no error.
TEST(CompareExit, PixelsMustCount) {
  const OneChannelOff folder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  folder.write("none.png", rgb_picture(2, 1, {0, 0, 0, 0, 0, 0}));
  folder.write("nan.exr", rgb_picture(2, 1, {nan, 0, 0, 0, 0, nan}));
  expect_one_line(folder.compare({"a.exr", "b.exr", "--mask", "none.png"}), 3,
                  "none.png: no pixel of the mask is white, so that none would count");
  expect_one_line(folder.compare({"nan.exr", "b.exr", "--json", "j"}), 3,
                  "nan.exr and b.exr: no pixel to compare: all are outside the mask or not finite");
  EXPECT_EQ(folder.names(), (Names{"a.exr", "b.exr", "nan.exr", "none.png"}));
}

TEST(CompareExit, ImpossibleZScoresAreReportedBeforeAnythingIsWritten) {
  const OneChannelOff folder;
  const RunResult run =
      folder.compare({"a.exr", "b.exr", "--diff", "d.png", "--z-scores", "z.exr", "--json", "j"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(lines_of(run.err), 1u) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(folder.names(), (Names{"a.exr", "b.exr"}));
}

TEST(CompareExit, HeadersSpeakAgainstTheComparison) {
  const CompareFolder folder;
  const auto write = [&](const char* name, ImageMetadata metadata) {
    folder.write(name, rgb_picture(1, 1, {1, 1, 1}, std::move(metadata)));
  };
  const std::string hash = "scene_hash";
  write("plain.exr", {});
  write("one.exr", {{hash, "01"}, {"seed", std::int64_t{3}}, {"sampler", "sobol"}});
  write("seed.exr", {{hash, "01"}, {"seed", std::int64_t{4}}, {"sampler", "sobol"}});
  write("other.exr", {{hash, "02"}, {"seed", std::int64_t{3}}, {"sampler", "sobol"}});
  write("biased.exr", {{"light_sampling", "line-ratio"}, {"light_sampling_biased", true}});
  write("part.exr", {{"complete", false}});
  write("alone.exr", {{"pixel_correlation", "none: independent"}});
  write("alike.exr", {{"pixel_correlation", "errors are alike"}});
  const std::string same =
      "note: both images were rendered with the same seed; their errors are not independent\n";
  for (const auto& [a, b, notes] : std::vector<std::array<std::string, 3>>{
           {"plain.exr", "plain.exr", ""},
           {"plain.exr", "one.exr", ""},
           {"one.exr", "seed.exr", ""},
           {"one.exr", "one.exr", same},
           {"one.exr", "other.exr",
            "warning: the images show different scenes (scene_hash 01 and 02)\n"},
           {"plain.exr", "biased.exr",
            "note: biased.exr: rendered by line-ratio, a biased method that does not converge to "
            "the "
            "true image\n"},
           {"plain.exr", "alone.exr", ""},
           {"alike.exr", "plain.exr", "note: alike.exr: errors are alike\n"},
           {"part.exr", "plain.exr", "warning: part.exr: the rendering was stopped early\n"}}) {
    const RunResult run = folder.compare({a, b, "--max-relmse", "0"});
    EXPECT_EQ(run.exit_code, 0) << a << " " << b;
    EXPECT_EQ(run.err, notes) << a << " " << b;
  }
}

TEST(CompareExit, ALineBreakInAFileNameMakesNoSecondLine) {
  const CompareFolder folder;
  folder.write("a\nb.exr", rgb_picture(1, 1, {1, 1, 1}, {{"complete", false}}));
  const RunResult run = folder.compare({"a\nb.exr", "a\nb.exr"});
  EXPECT_EQ(run.exit_code, 0);
  const std::string note = "warning: a b.exr: the rendering was stopped early\n";
  EXPECT_EQ(run.err, note + note);
  EXPECT_TRUE(run.out.starts_with("x = a b.exr\nr = a b.exr\n")) << run.out;
}

TEST(CompareExit, RenderedPicturesCarryWhatTheNotesNeed) {
  const CompareFolder folder;
  ASSERT_EQ(folder.render({"-o", "a.exr", "--light-sampling", "line-ratio"}).exit_code, 0);
  ASSERT_EQ(folder.render({"-o", "b.exr", "--seed", "2", "--variance"}).exit_code, 0);
  const std::string notes = folder.compare({"a.exr", "b.exr"}).err;
  EXPECT_TRUE(notes.starts_with(
      "note: the images were rendered by different methods (line-ratio and point)\n"
      "note: a.exr: rendered by line-ratio, a biased"))
      << notes;
  EXPECT_NE(notes.find("note: b.exr: errors of pixels less than 16 apart are correlated"),
            std::string::npos)
      << notes;
}

TEST(CompareExit, BadPicturesEndWithThree) {
  const OneChannelOff folder;
  folder.write("wide.exr", rgb_picture(3, 1, std::vector<float>(9)));
  folder.folder.write("text.png", "no picture");
  folder.folder.write("cut.exr", folder.bytes("a.exr").substr(0, 300));
  const Names before = folder.names();
  const auto compare = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "j", "--diff", "d.png"});
    return folder.compare(arguments);
  };
  expect_one_line(compare({"nope.exr", "a.exr"}), 3, "nope.exr: No such file or directory");
  expect_one_line(
      compare({"a.exr", "text.png"}), 3,
      "text.png: not an image of a known format: EXR, PNG, TIFF, JPEG, HDR, PFM or PNM");
  expect_one_line(compare({"a.exr", "wide.exr"}), 3,
                  "a.exr: 2x1 pixels, but wide.exr has 3x1 pixels");
  expect_one_line(compare({"a.exr", "b.exr", "--mask", "wide.exr"}), 3,
                  "wide.exr: 3x1 pixels, but the pictures have 2x1");
  const RunResult cut = compare({"cut.exr", "b.exr"});
  EXPECT_EQ(cut.exit_code, 3);
  EXPECT_EQ(lines_of(cut.err), 1u);
  EXPECT_TRUE(cut.err.starts_with("Raytracing: cut.exr: ")) << cut.err;
  EXPECT_EQ(folder.names(), before);
}

TEST(CompareExit, WrongUseEndsWithTwo) {
  const OneChannelOff folder;
  const std::string hint = " (--help lists all options)";
  expect_one_line(folder.compare({}), 2, "two images are needed" + hint);
  expect_one_line(folder.compare({"a.exr"}), 2, "two images are needed" + hint);
  expect_one_line(folder.compare({"a.exr", "b.exr", "c.exr"}), 2,
                  "c.exr: one argument too many" + hint);
  expect_one_line(folder.compare({"a.exr", "b.exr", "--dif", "x.png"}), 2,
                  "--dif: unknown option; the nearest is --diff" + hint);
  expect_one_line(
      folder.compare({"a.exr", "b.exr", "--diff", "x.foo"}), 2,
      "x.foo: the name of an image must end in one of .exr .hdr .tif .tiff .png .jpg .jpeg "
      ".bmp .dpx .ppm .sgi .tga");
  for (const std::string limit : {"x", "1x", "nan", "inf", "", "0x1p3", "1,5"})
    expect_one_line(folder.compare({"a.exr", "b.exr", "--max-relmse=" + limit}), 2,
                    limit.empty() ? "--max-relmse: needs a value" + hint
                                  : "--max-relmse: '" + limit + "' is not a number");
  const RunResult negative = folder.compare({"a.exr", "b.exr", "--max-relmse", "-1"});
  EXPECT_EQ(negative.exit_code, 2);
  EXPECT_TRUE(negative.err.starts_with("Raytracing: --max-relmse: -1 is not between 0 and "))
      << negative.err;
}

TEST(CompareExit, OutputsThatCannotBeWrittenEndWithFour) {
  const OneChannelOff folder;
  for (const std::vector<std::string>& outputs : {std::vector<std::string>{"--json", "nope/j"},
                                                  {"--diff", "nope/d.png"},
                                                  {"--diff", "d.png", "--json", "nope/j"},
                                                  {"--json", "."}}) {
    std::vector<std::string> arguments = {"a.exr", "b.exr"};
    arguments.insert(arguments.end(), outputs.begin(), outputs.end());
    const RunResult run = folder.compare(arguments);
    EXPECT_EQ(run.exit_code, 4);
    EXPECT_EQ(lines_of(run.err), 1u) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(folder.names(), (Names{"a.exr", "b.exr"}));
  }
}

}  // namespace
}  // namespace raytracing
