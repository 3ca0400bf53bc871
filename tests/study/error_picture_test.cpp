#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "raytracing/io/errors.h"
#include "raytracing/io/srgb.h"
#include "raytracing/study/metrics/error_metrics.h"

namespace raytracing {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
using Codes = std::array<int, 3>;

ImageData row(const std::vector<float>& greys) {
  ImageData image{static_cast<int>(greys.size()), 1, {"R", "G", "B"}, {}, {}};
  for (const float grey : greys) image.values.insert(image.values.end(), 3, grey);
  return image;
}

Codes codes_at(const ImageData& image, int x, int y) {
  const auto at = 3 * static_cast<std::size_t>(y * image.width + x);
  return {srgb8(image.values.at(at)), srgb8(image.values.at(at + 1)),
          srgb8(image.values.at(at + 2))};
}

Codes codes_of(const Rgb& colour) {
  return {static_cast<int>(std::lround(colour.x)), static_cast<int>(std::lround(colour.y)),
          static_cast<int>(std::lround(colour.z))};
}

/// Differs from a reference of 0 by a pixel error of 10^decade.
float with_error(double decade) {
  return static_cast<float>(std::sqrt(kRelMseEpsilon * std::pow(10, decade)));
}

// With a power in place of the sRGB curve, near enough to order colours.
double luminance(const Rgb& c) {
  return 0.2126 * std::pow(c.x, 2.2) + 0.7152 * std::pow(c.y, 2.2) + 0.0722 * std::pow(c.z, 2.2);
}

TEST(RelativeSquaredErrors, AddUpToRelMse) {
  ImageData test = row({1, 2, 0.5f}), reference = row({1.5f, 2, 0});
  test.values[1] = -3;
  const std::vector<float> errors = relative_squared_errors(test, reference);
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_NEAR((double{errors[0]} + double{errors[1]} + double{errors[2]}) / 3,
              error_metrics(test, reference).relmse, 1e-5);
  EXPECT_EQ(errors[1], 0);
  EXPECT_FLOAT_EQ(errors[2], 25);
}

TEST(RelativeSquaredErrors, AreFiniteWhereThePicturesAre) {
  EXPECT_EQ(relative_squared_errors(row({3e38f}), row({-3e38f}))[0], 4);
  EXPECT_EQ(relative_squared_errors(row({3e38f}), row({0}))[0], std::numeric_limits<float>::max());
  EXPECT_TRUE(std::isnan(relative_squared_errors(row({kNan}), row({0}))[0]));
  EXPECT_THROW(relative_squared_errors(row({1}), row({1, 2})), InputError);
}

TEST(Magma, GetsLighterAllTheWay) {
  for (int i = 0; i < 1000; ++i)
    ASSERT_GT(luminance(magma((i + 1) / 1000.0)), luminance(magma(i / 1000.0))) << i;
  EXPECT_EQ(magma(-1), magma(0));
  EXPECT_EQ(magma(2), magma(1));
  EXPECT_EQ(codes_of(magma(0)), (Codes{0, 0, 4}));
  EXPECT_EQ(codes_of(magma(1)), (Codes{252, 253, 191}));
}

TEST(ErrorPicture, ShowsTheLogarithm) {
  const ImageData test =
      row({0, with_error(-7), with_error(-5), with_error(-2), with_error(1), with_error(3)});
  const ImageData picture = error_picture(test, row({0, 0, 0, 0, 0, 0}));
  const double expected[] = {0, 0, 0, 0.5, 1, 1};
  for (int x = 0; x < 6; ++x) EXPECT_EQ(codes_at(picture, x, 0), codes_of(magma(expected[x]))) << x;
}

TEST(ErrorPicture, MarksWhatHasNoError) {
  const ImageData test = row({1, kNan, kNan}), reference = row({1, 1, 1});
  const ImageData picture = error_picture(test, reference, {1, 1, 0});
  EXPECT_EQ(codes_at(picture, 0, 0), codes_of(magma(0)));
  EXPECT_EQ(codes_at(picture, 1, 0), (Codes{0, 255, 255}));
  EXPECT_EQ(codes_at(picture, 2, 0), (Codes{96, 96, 96}));
  EXPECT_THROW(error_picture(test, reference, {1}), InputError);
}

/// Where the picture's ink (white) is, one line of text a row.
std::string drawing(const ImageData& image, int left, int top, int width, int height) {
  std::string text;
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x)
      text += codes_at(image, x, y) == Codes{255, 255, 255} ? '#' : '.';
    text += '\n';
  }
  return text;
}

// The last label of the scale 1e-5 .. 1e1 of the narrowest picture, and the bar above it.
TEST(ErrorPicture, HasALegend) {
  const ImageData picture = error_picture(row({1}), row({1}));
  EXPECT_EQ(picture.width, 160);
  const int bar = 1 + 3 + 5;
  EXPECT_EQ(codes_at(picture, 16, bar), codes_of(magma(0)));
  EXPECT_EQ(codes_at(picture, 143, bar), codes_of(magma(1)));
  const int label = 1 + 3 + 10 + 6;
  EXPECT_EQ(drawing(picture, 134, label, 18, 7),
            "..#...........#...\n"
            ".##..........##...\n"
            "..#....###....#...\n"
            "..#...#...#...#...\n"
            "..#...#####...#...\n"
            "..#...#.......#...\n"
            ".###...###...###..\n");
}

TEST(ErrorPicture, HasTheErrorMapAbove) {
  const ImageData test = row(std::vector<float>(200, 1));
  const ImageData reference = row(std::vector<float>(200, 0.5f));
  const ImageData map = error_map(test, reference), picture = error_picture(test, reference);
  EXPECT_EQ(map.width, 200);
  EXPECT_EQ(map.height, 1);
  EXPECT_TRUE(std::equal(map.values.begin(), map.values.end(), picture.values.begin()));
}

TEST(ErrorPicture, IsAsWideAsThePicture) {
  const std::vector<float> greys(700);
  const ImageData picture = error_picture(row(greys), row(greys));
  EXPECT_EQ(picture.width, 700);
  EXPECT_EQ(picture.values.size(),
            3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
}

}  // namespace
}  // namespace raytracing
