#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/compare_folder.h"

// Images that are parts of a picture, have layers, or say that a comparison is not fair.

namespace raytracing {
namespace {

/// A crop at x,y of a whole picture of that size, of a picture whose grey is 10 y + x.
ImageData crop(const PixelWindow& window, int width, int height) {
  ImageData image = rgb_picture(window.width, window.height, {});
  for (int y = 0; y < window.height; ++y)
    for (int x = 0; x < window.width; ++x)
      image.values.insert(image.values.end(), 3,
                          static_cast<float>(10 * (window.y + y) + window.x + x));
  image.whole = PixelWindow{-window.x, -window.y, width, height};
  return image;
}

bool has_row(const RunResult& run, const std::string& label, const std::string& value) {
  const std::size_t at = run.out.find("\n" + label + " ");
  return at != std::string::npos &&
         run.out.substr(at + label.size() + 2, 40).find(" " + value + " ") != std::string::npos;
}

TEST(CompareParts, PixelsAreComparedWhereTheyAre) {
  const CompareFolder folder;
  ImageData whole = crop({0, 0, 9, 8}, 9, 8);
  folder.write("whole.exr", whole);
  folder.write("crop.exr", crop({3, 2, 4, 5}, 9, 8));
  folder.write("other.exr", crop({5, 0, 4, 4}, 9, 8));
  RunResult run = folder.compare({"crop.exr", "whole.exr"});
  EXPECT_EQ(run.err, "note: only the 4x5 pixels at 3,2 that both images have are compared\n");
  EXPECT_TRUE(has_row(run, "MSE", "0")) << run.out;
  run = folder.compare({"crop.exr", "other.exr"});
  EXPECT_EQ(run.err, "note: only the 2x2 pixels at 5,2 that both images have are compared\n");
  EXPECT_TRUE(has_row(run, "MSE", "0")) << run.out;
}

TEST(CompareParts, ThePixelOfTheLargestErrorIsThatOfTheWholePicture) {
  const CompareFolder folder;
  ImageData part = crop({3, 2, 4, 5}, 9, 8);
  part.values[3 * (4 * 2 + 1)] += 1;  // its pixel 1,2
  folder.write("whole.exr", crop({0, 0, 9, 8}, 9, 8));
  folder.write("crop.exr", part);
  EXPECT_NE(folder.compare({"crop.exr", "whole.exr"}).out.find("at pixel 4,4"), std::string::npos);
}

TEST(CompareParts, AMaskIsThatOfTheWholePicture) {
  const CompareFolder folder;
  ImageData part = crop({3, 2, 4, 5}, 9, 8),
            mask = rgb_picture(9, 8, std::vector<float>(9 * 8 * 3));
  part.values[0] += 3;  // the pixel 3,2
  for (const int pixel : {2 * 9 + 3, 2 * 9 + 4})
    for (int c = 0; c < 3; ++c) mask.values[static_cast<std::size_t>(3 * pixel + c)] = 1;
  folder.write("whole.exr", crop({0, 0, 9, 8}, 9, 8));
  folder.write("crop.exr", part);
  folder.write("mask.exr", mask);
  const RunResult run = folder.compare({"crop.exr", "whole.exr", "--mask", "mask.exr"});
  EXPECT_TRUE(has_row(run, "MSE", "1.5")) << run.out;  // 9 / 6 channels
}

TEST(CompareParts, WithoutACommonPixelAreRefused) {
  const CompareFolder folder;
  folder.write("a.exr", crop({0, 0, 3, 3}, 9, 8));
  folder.write("b.exr", crop({3, 2, 4, 5}, 9, 8));
  folder.write("c.exr", crop({0, 0, 3, 3}, 18, 14));
  folder.write("d.exr", rgb_picture(3, 3, std::vector<float>(27)));
  expect_one_line(folder.compare({"a.exr", "b.exr"}), 3,
                  "a.exr: 3x3 pixels at 0,0 of 9x8, but b.exr has 4x5 pixels at 3,2 of 9x8");
  expect_one_line(folder.compare({"a.exr", "c.exr"}), 3,
                  "a.exr: 3x3 pixels at 0,0 of 9x8, but c.exr has 3x3 pixels at 0,0 of 18x14");
  expect_one_line(folder.compare({"d.exr", "b.exr"}), 3,
                  "d.exr: 3x3 pixels, but b.exr has 4x5 pixels at 3,2 of 9x8");
}

TEST(CompareLayers, AreChosenByName) {
  const CompareFolder folder;
  folder.write("a.exr",
               {1, 1, {"R", "G", "B", "direct.R", "direct.G", "direct.B"}, {9, 9, 9, 1, 2, 3}, {}});
  folder.write("b.exr", rgb_picture(1, 1, {1, 2, 3}));
  RunResult run = folder.compare({"a.exr", "b.exr", "--layer", "direct"});
  EXPECT_TRUE(has_row(run, "MSE", "0")) << run.out;
  EXPECT_EQ(run.err, "note: a.exr: its layer 'direct' was read\n");
  run = folder.compare({"b.exr", "a.exr", "--reference-layer", "direct"});
  EXPECT_TRUE(has_row(run, "MSE", "0")) << run.out;
  EXPECT_EQ(folder.compare({"a.exr", "b.exr", "--layer", "indirect"}).err,
            "Raytracing: a.exr: has no layer 'indirect'; its layers are '', 'direct'\n");
}

TEST(CompareFacts, ThatMakeAComparisonUnfairAreTold) {
  const CompareFolder folder;
  const auto write = [&](const std::string& name, const ImageMetadata& metadata) {
    folder.write(name, rgb_picture(1, 1, {1, 1, 1}, metadata));
  };
  write("a.exr", {{"scene_hash", "00aa"},
                  {"max_depth", std::int64_t{1}},
                  {"width", std::int64_t{1}},
                  {"height", std::int64_t{1}},
                  {"light_sampling", "point"}});
  write("b.exr", {{"scene_hash", "00bb"},
                  {"max_depth", "unlimited"},
                  {"width", std::int64_t{2}},
                  {"height", std::int64_t{1}},
                  {"light_sampling", "line"}});
  EXPECT_EQ(folder.compare({"a.exr", "b.exr"}).err,
            "warning: the images show different scenes (scene_hash 00aa and 00bb)\n"
            "warning: the images differ in depth (max_depth 1 and unlimited)\n"
            "warning: the images were rendered at different sizes (1x1 and 2x1)\n"
            "note: the images were rendered by different methods (point and line)\n");
  EXPECT_EQ(folder.compare({"a.exr", "a.exr"}).err, "");
}

// Profiles and the like are converted for all inputs, and each is named.
TEST(CompareNotes, NameTheImageThatWasConverted) {
  const CompareFolder folder;
  folder.write("grey.exr", {1, 1, {"Y"}, {1}, {}});
  folder.write("rgb.exr", rgb_picture(1, 1, {1, 1, 1}));
  const std::string note = "it has one channel, which was read as red, green and blue\n";
  EXPECT_EQ(folder.compare({"rgb.exr", "rgb.exr", "--mask", "grey.exr"}).err,
            "note: grey.exr: " + note);
  EXPECT_EQ(folder.compare({"grey.exr", "rgb.exr"}).err, "note: grey.exr: " + note);
}

}  // namespace
}  // namespace raytracing
