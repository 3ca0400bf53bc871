#include "raytracing/study/metrics/error_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

ImageData picture(int width, int height, std::vector<float> values) {
  return {width, height, {"R", "G", "B"}, std::move(values), {}};
}

/// 6x5 pixels; value i is (a i mod m) / 64 - 0.25, exact in float.
ImageData pattern(int a, int m) {
  ImageData image = picture(6, 5, {});
  for (int i = 0; i < 6 * 5 * 3; ++i)
    image.values.push_back(static_cast<float>(a * i % m) / 64 - 0.25f);
  return image;
}

void expect_close(double value, double expected) {
  EXPECT_NEAR(value, expected, 1e-13 * std::abs(expected));
}

// i = numpy.arange(90); x = 37*i%101/64-.25; r = 53*i%89/64-.25; d = x-r
// numpy: (d*d).mean(), (d*d).mean()**.5, (d*d/(r*r+.01)).mean(), abs(d).mean(),
//   -10*numpy.log10((d*d).mean()), (abs(d)/(abs(x)+abs(r)+.01)).mean(),
//   x.reshape(-1,3).mean(0)/r.reshape(-1,3).mean(0), abs(d).max(), abs(d).argmax()//3
TEST(ErrorMetrics, AgreeWithNumpy) {
  const ErrorMetrics m = error_metrics(pattern(37, 101), pattern(53, 89));
  expect_close(m.mse, 0.37564019097222223);
  expect_close(m.rmse, 0.6128949265349014);
  expect_close(m.relmse, 9.488006130868312);
  expect_close(m.mae, 0.5006944444444444);
  expect_close(m.psnr, 4.252279473333588);
  expect_close(m.smape, 0.5565123992218872);
  expect_close(m.mean_ratio.x, 1.339331619537275);
  expect_close(m.mean_ratio.y, 1.2175438596491228);
  expect_close(m.mean_ratio.z, 1.113879003558719);
  EXPECT_EQ(m.largest, 1.421875);
  EXPECT_EQ(m.largest_y * 6 + m.largest_x, 26);
  EXPECT_EQ(m.pixels, 30u);
}

// The same with k = numpy.arange(30)%3 != 1 and the rows k of x.reshape(-1,3) and r.reshape(-1,3).
TEST(ErrorMetrics, AgreeWithNumpyUnderAMask) {
  PixelMask mask;
  for (int i = 0; i < 30; ++i) mask.push_back(i % 3 == 1 ? 0 : 255);
  const ErrorMetrics m = error_metrics(pattern(37, 101), pattern(53, 89), mask);
  expect_close(m.mse, 0.3933837890625);
  expect_close(m.rmse, 0.6272031481605461);
  expect_close(m.relmse, 8.475327064251863);
  expect_close(m.mae, 0.5203125);
  expect_close(m.psnr, 4.051835408726122);
  expect_close(m.smape, 0.5681502210821762);
  expect_close(m.mean_ratio.x, 1.3517382413087933);
  expect_close(m.mean_ratio.y, 1.2175438596491228);
  expect_close(m.mean_ratio.z, 1.113879003558719);
  EXPECT_EQ(m.largest, 1.421875);
  EXPECT_EQ(m.largest_y * 6 + m.largest_x, 26);
  EXPECT_EQ(m.pixels, 20u);
}

// By hand: differences 1, 0, 0 and 0, 0, -2.
TEST(ErrorMetrics, OfTwoPixels) {
  const ErrorMetrics m =
      error_metrics(picture(1, 2, {2, 1, 0, 3, 1, 1}), picture(1, 2, {1, 1, 0, 3, 1, 3}));
  EXPECT_DOUBLE_EQ(m.mse, 5.0 / 6);
  EXPECT_DOUBLE_EQ(m.rmse, std::sqrt(5.0 / 6));
  EXPECT_DOUBLE_EQ(m.relmse, (1 / 1.01 + 4 / 9.01) / 6);
  EXPECT_DOUBLE_EQ(m.mae, 0.5);
  EXPECT_DOUBLE_EQ(m.smape, (1 / 3.01 + 2 / 4.01) / 6);
  EXPECT_NEAR(m.psnr, 0.7918124604762482, 1e-14);
  EXPECT_EQ(m.mean_ratio, DVec3(5.0 / 4, 1, 1.0 / 3));
  EXPECT_EQ(m.largest, 2);
  EXPECT_EQ(m.largest_x, 0);
  EXPECT_EQ(m.largest_y, 1);
  EXPECT_EQ(m.pixels, 2u);
}

TEST(ErrorMetrics, OfEqualPictures) {
  const ErrorMetrics m = error_metrics(pattern(37, 101), pattern(37, 101));
  for (const double zero : {m.mse, m.rmse, m.relmse, m.mae, m.smape, m.largest}) EXPECT_EQ(zero, 0);
  EXPECT_EQ(m.psnr, double{kInfinity});
  EXPECT_EQ(m.mean_ratio, DVec3(1));
  EXPECT_EQ(m.largest_x, 0);
  EXPECT_EQ(m.largest_y, 0);
}

TEST(ErrorMetrics, NonFinitePixelsAreCountedAndLeftOut) {
  const float big = 1e30f;
  const ErrorMetrics m = error_metrics(
      picture(5, 1, {kNan, big, big, 1, 1, 1, big, big, -kInfinity, 0, 0, 0, 3, 3, 3}),
      picture(5, 1, {big, 0, 0, 0, kInfinity, 0, kNan, 0, 0, 1, 0, 0, 3, 3, 3}));
  EXPECT_EQ(m.non_finite_test, 2u);
  EXPECT_EQ(m.non_finite_reference, 2u);
  EXPECT_EQ(m.pixels, 2u);
  EXPECT_DOUBLE_EQ(m.mse, 1.0 / 6);
  EXPECT_EQ(m.largest, 1);
  EXPECT_EQ(m.largest_x, 3);
}

TEST(ErrorMetrics, WithoutAPixelAreNotNumbers) {
  const ImageData image = picture(1, 1, {1, 2, 3});
  const ErrorMetrics m = error_metrics(image, image, {0});
  EXPECT_EQ(m.pixels, 0u);
  EXPECT_EQ(m.largest_x, -1);
  for (const double mean : {m.mse, m.rmse, m.relmse, m.mae, m.psnr, m.smape, m.mean_ratio.x})
    EXPECT_TRUE(std::isnan(mean));
}

TEST(ErrorMetrics, FindTheChannelsByName) {
  const ImageData test{1, 1, {"variance.R", "B", "G", "R"}, {9, 3, 2, 1}, {}};
  EXPECT_EQ(error_metrics(test, picture(1, 1, {1, 2, 3})).largest, 0);
}

TEST(ErrorMetrics, RefuseWhatDoesNotFit) {
  const ImageData image = picture(2, 1, {0, 0, 0, 0, 0, 0});
  EXPECT_THROW(error_metrics(image, picture(1, 2, image.values)), InputError);
  EXPECT_THROW(error_metrics(image, image, {1}), InputError);
  EXPECT_THROW(error_metrics(image, {2, 1, {"Y"}, {0, 0}, {}}), InputError);
}

TEST(PixelMask, WhiteCounts) {
  EXPECT_EQ(
      to_mask(picture(5, 1, {1, 1, 1, 0, 0, 0, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.4f, kNan, 1, 1})),
      (PixelMask{1, 0, 1, 0, 0}));
}

}  // namespace
}  // namespace raytracing
