#include "raytracing/study/metrics/error_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "raytracing/io/errors.h"
#include "raytracing/io/image_library.h"
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

Codes magma_codes(float value) {
  const std::vector<float> colour = image_library().magma({value});
  return {srgb8(colour[0]), srgb8(colour[1]), srgb8(colour[2])};
}

/// Differs from a reference of 0 by a pixel error of 10^decade.
float with_error(double decade) {
  return static_cast<float>(std::sqrt(kRelMseEpsilon * std::pow(10, decade)));
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

// The ends and the middle are those of matplotlib's table: its rows 0, 127.5 and 255.
TEST(Magma, GetsLighterAllTheWay) {
  std::vector<float> values(1001);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i) / 1000;
  const std::vector<float> colours = image_library().magma(values);
  ASSERT_EQ(colours.size(), 3 * values.size());
  const auto luminance = [&](std::size_t i) {
    return 0.2126f * colours[3 * i] + 0.7152f * colours[3 * i + 1] + 0.0722f * colours[3 * i + 2];
  };
  for (std::size_t i = 0; i < 1000; ++i) ASSERT_GT(luminance(i + 1), luminance(i)) << i;
  EXPECT_EQ(magma_codes(0), (Codes{0, 0, 4}));
  EXPECT_EQ(magma_codes(1), (Codes{252, 253, 191}));
  const Codes middle = magma_codes(0.5f);
  EXPECT_NEAR(middle[0], 183, 4);
  EXPECT_NEAR(middle[1], 55, 4);
  EXPECT_NEAR(middle[2], 121, 4);
}

TEST(ErrorPicture, ShowsTheLogarithm) {
  const ImageData test =
      row({0, with_error(-7), with_error(-5), with_error(-2), with_error(1), with_error(3)});
  const ImageData picture = error_picture(test, row({0, 0, 0, 0, 0, 0}));
  const float expected[] = {0, 0, 0, 0.5f, 1, 1};
  for (int x = 0; x < 6; ++x) EXPECT_EQ(codes_at(picture, x, 0), magma_codes(expected[x])) << x;
}

TEST(ErrorPicture, MarksWhatHasNoError) {
  const ImageData test = row({1, kNan, kNan}), reference = row({1, 1, 1});
  const ImageData picture = error_picture(test, reference, {1, 1, 0});
  EXPECT_EQ(codes_at(picture, 0, 0), magma_codes(0));
  EXPECT_EQ(codes_at(picture, 1, 0), (Codes{0, 255, 255}));
  EXPECT_EQ(codes_at(picture, 2, 0), (Codes{96, 96, 96}));
  EXPECT_THROW(error_picture(test, reference, {1}), InputError);
}

/// The columns of the picture in which rows of text are drawn, from the first to the last.
std::array<int, 2> inked_columns(const ImageData& image, int left, int right, int top, int bottom) {
  std::array<int, 2> columns{right, left};
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      if (codes_at(image, x, y)[0] > 128) {
        columns[0] = std::min(columns[0], x);
        columns[1] = std::max(columns[1], x);
      }
  return columns;
}

// The bar, and the last label of the scale 1e-5 .. 1e1 of the narrowest picture below its end.
TEST(ErrorPicture, HasALegend) {
  const ImageData picture = error_picture(row({1}), row({1}));
  EXPECT_EQ(picture.width, 160);
  const int bar = 1 + 3 + 5;
  EXPECT_EQ(codes_at(picture, 16, bar), magma_codes(0));
  EXPECT_EQ(codes_at(picture, 143, bar), magma_codes(1));
  const int label = 1 + 3 + 10 + 6, font = 11;
  const auto [first, last] = inked_columns(picture, 120, 160, label, label + font);
  EXPECT_NEAR((first + last) / 2.0, 143, 2);
  EXPECT_NEAR(last - first, 20, 6);
  const auto formula = inked_columns(picture, 0, 160, label + font + 3, picture.height);
  EXPECT_NEAR((formula[0] + formula[1]) / 2.0, 80, 2);
  EXPECT_GT(formula[1] - formula[0], 70);
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
