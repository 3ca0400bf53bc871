// tests/data/flip/make.py tells how the pictures and the package's answers were made.

#include "raytracing/study/metrics/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "raytracing/io/errors.h"
#include "raytracing/io/image.h"
#include "raytracing/study/metrics/pixels.h"

namespace raytracing {
namespace {

ImageData stored(const std::string& name) {
  return read_image(std::string(RAYTRACING_SOURCE_DIR "/tests/data/flip/") + name);
}

ImageData uniform(int width, int height, Rgb colour) {
  ImageData image{width, height, {"R", "G", "B"}, {}, {}};
  for (int i = 0; i < width * height; ++i)
    for (const float c : {colour.x, colour.y, colour.z}) image.values.push_back(c);
  return image;
}

// The package computes in float and rounds its constants.
constexpr double kTolerance = 2e-5;

TEST(Flip, AgreesWithThePackagePixelByPixel) {
  const ImageData test = stored("test.png"), reference = stored("reference.png");
  const ImageData expected = stored("flip.exr");
  const RgbView answers(expected);
  const double ppd[] = {67, 30, 120};
  for (int column = 0; column < 3; ++column) {
    const std::vector<float> map = flip_map(test, reference, ppd[column]);
    ASSERT_EQ(map.size(), answers.pixels());
    double worst = 0;
    for (std::size_t i = 0; i < map.size(); ++i)
      worst = std::max(worst, std::abs(double{map[i]} - answers[i][column]));
    EXPECT_LT(worst, kTolerance) << ppd[column];
  }
}

TEST(Flip, AgreesWithThePackageInTheMean) {
  const std::vector<float> map = flip_map(stored("test.png"), stored("reference.png"));
  EXPECT_NEAR(masked_mean(map), 0.1036701500415802, 1e-5);
}

TEST(Flip, OfEqualPicturesIsZero) {
  const ImageData image = stored("test.png");
  for (const float error : flip_map(image, image)) ASSERT_EQ(error, 0);
}

// The definition's scale: nothing is farther apart than green and blue.
TEST(Flip, OfGreenAndBlueIsOne) {
  for (const float error : flip_map(uniform(9, 7, {0, 1, 0}), uniform(9, 7, {0, 0, 1})))
    ASSERT_NEAR(error, 1, 1e-5);
}

TEST(Flip, CutsOffWhatAScreenCannotShow) {
  const float infinity = std::numeric_limits<float>::infinity();
  const ImageData white = uniform(3, 3, {1, 1, 1}), black = uniform(3, 3, {0, 0, 0});
  EXPECT_EQ(masked_mean(flip_map(uniform(3, 3, {infinity, 7, 1}), white)), 0);
  EXPECT_EQ(masked_mean(flip_map(uniform(3, 3, {-1, -infinity, std::nanf("")}), black)), 0);
  EXPECT_GT(masked_mean(flip_map(white, black)), 0.5);
}

TEST(Flip, TakesPicturesSmallerThanItsFilters) {
  EXPECT_EQ(flip_map(uniform(1, 1, {1, 0, 0}), uniform(1, 1, {0, 1, 0})).size(), 1u);
  EXPECT_THROW(flip_map(uniform(1, 2, {1, 0, 0}), uniform(2, 1, {0, 1, 0})), InputError);
}

TEST(MaskedMean, TakesWhatCounts) {
  EXPECT_EQ(masked_mean({1, 2, 6}), 3);
  EXPECT_EQ(masked_mean({1, 2, 6}, {1, 0, 9}), 3.5);
  EXPECT_TRUE(std::isnan(masked_mean({1, 2}, {0, 0})));
}

}  // namespace
}  // namespace raytracing
