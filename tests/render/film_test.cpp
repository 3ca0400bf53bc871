#include "raytracing/render/film.h"

#include <gtest/gtest.h>

namespace raytracing {
namespace {

TEST(Film, PixelHasMeanAndVarianceOfItsSamples) {
  Film::Pixel pixel;
  EXPECT_EQ(pixel.mean(), DVec3(0.0));
  EXPECT_EQ(pixel.variance_of_mean(), DVec3(0.0));
  pixel.add({2.0f, 5.0f, 0.0f});
  EXPECT_EQ(pixel.mean(), DVec3(2.0, 5.0, 0.0));
  EXPECT_EQ(pixel.variance_of_mean(), DVec3(0.0));
  pixel.add({4.0f, 5.0f, 0.0f});
  pixel.add({4.0f, 5.0f, 0.0f});
  pixel.add({6.0f, 5.0f, 12.0f});
  EXPECT_EQ(pixel.samples, 4u);
  EXPECT_EQ(pixel.mean(), DVec3(4.0, 5.0, 3.0));
  // Squares about the mean: 8, 0 and 108; over n (n - 1) = 12.
  EXPECT_NEAR(pixel.variance_of_mean().x, 8.0 / 12, 1e-15);
  EXPECT_EQ(pixel.variance_of_mean().y, 0);
  EXPECT_NEAR(pixel.variance_of_mean().z, 9, 1e-14);
}

// Rounding must not make a variance negative.
TEST(Film, VarianceOfEqualSamplesIsNotNegative) {
  Film::Pixel pixel;
  for (int i = 0; i < 1000; ++i) {
    pixel.add(Rgb(0.1f, 1e6f / 3, 1e-6f));
    const DVec3 v = pixel.variance_of_mean();
    EXPECT_TRUE(v.x >= 0 && v.y >= 0 && v.z >= 0);
    EXPECT_LT(v.x, 1e-17);
  }
}

TEST(Film, MeanIsThatOfThePixelsWhateverTheirSamples) {
  Film film(2, 1);
  film.at(0, 0).add(Rgb(1.0f));
  for (int i = 0; i < 3; ++i) film.at(1, 0).add(Rgb(4.0f));
  EXPECT_EQ(film.mean(), DVec3(2.5));
}

TEST(Film, ReplicatesCountWhenTheyAreComplete) {
  Film::Pixel pixel;
  pixel.add(Rgb(1.0f), 2);
  EXPECT_EQ(pixel.mean(), DVec3(1.0));
  EXPECT_EQ(pixel.replicates, 0u);
  pixel.add(Rgb(3.0f), 2);  // mean 2
  EXPECT_EQ(pixel.variance_of_mean(), DVec3(0.0));
  for (const float sample : {4.0f, 8.0f}) pixel.add(Rgb(sample), 2);  // mean 6
  EXPECT_EQ(pixel.mean(), DVec3(4.0));
  EXPECT_EQ(pixel.variance_of_mean(), DVec3(4.0));  // 8 / (2 - 1) / 2
  pixel.add(Rgb(100.0f), 2);
  EXPECT_EQ(pixel.mean(), DVec3(4.0));
  EXPECT_EQ(pixel.variance_of_mean(), DVec3(4.0));
  EXPECT_EQ(pixel.samples, 5u);
  EXPECT_EQ(pixel.counted, 4u);
}

TEST(Film, RowsRunFromTheTop) {
  Film film(3, 2);
  film.at(2, 1).add(Rgb(1.0f));
  EXPECT_EQ(&film.at(2, 1) - &film.at(0, 0), 5);
}

}  // namespace
}  // namespace raytracing
