// The bias of a method from its pictures: none is found where there is none, half a per cent is.

#include <gtest/gtest.h>

#include "raytracing/study/metrics/reference.h"
#include "study/noisy_pictures.h"
#include "support/p_values.h"

namespace raytracing {
namespace {

constexpr int kSeeds = 8;  // the default of chart

struct Trial {
  double sigma = 0.2;             // of each seed's picture
  double reference_sigma = 0.05;  // of each half of the reference
  double factor = 1;              // of the method's expectation
};

BiasEstimate estimate(NoisyPictures& maker, const Trial& trial) {
  const ImageData a = maker.picture(trial.reference_sigma);
  const ImageData b = maker.picture(trial.reference_sigma);
  const Reference reference = to_reference(join_halves(a, b));
  SeedMoments moments;
  for (int seed = 0; seed < kSeeds; ++seed) moments.add(maker.picture(trial.sigma, trial.factor));
  return *estimate_bias(moments, reference, counted_pixels(reference.picture, {}));
}

TEST(Bias, MomentsAreMeanAndVariance) {
  NoisyPictures maker(1, 1);
  SeedMoments moments;
  ImageData picture = maker.picture(0);
  for (const float value : {1.0f, 2.0f, 4.0f}) {
    picture.values = {value, 2 * value, 0};
    moments.add(picture);
  }
  EXPECT_NEAR(moments.mean()[0].x, 7.0 / 3, 1e-15);
  EXPECT_NEAR(moments.variance_of_mean(0).x, 7.0 / 9, 1e-15);
  EXPECT_NEAR(moments.variance_of_mean(0).y, 28.0 / 9, 1e-14);
  EXPECT_EQ(moments.variance_of_mean(0).z, 0);
}

TEST(Bias, OfAnUnbiasedMethodScattersAboutZeroAndIsNotFlagged) {
  constexpr int kRepetitions = 300;
  NoisyPictures maker(32, 5);
  RunningStats squared, mean_ratio;
  int flagged = 0, covered = 0;
  for (int i = 0; i < kRepetitions; ++i) {
    const BiasEstimate bias = estimate(maker, {});
    flagged += bias.detected;
    squared.add(bias.squared.value / bias.squared.standard_error);
    mean_ratio.add(bias.mean_ratio.value / bias.mean_ratio.standard_error);
    covered += std::abs(bias.squared.value) < 1.960 * bias.squared.standard_error;
  }
  PValues tests;
  tests.add("z of bias^2", mean_p_value(squared, 0));
  tests.add("z of the mean", mean_p_value(mean_ratio, 0));
  tests.add("coverage of bias^2",
            normal_p_value((covered - 0.95 * kRepetitions) / std::sqrt(0.0475 * kRepetitions)));
  tests.expect_all();
  // 1 of 100 promised: 3 expected, and P(more than 10) < 1e-3 for a Poisson number.
  EXPECT_LE(flagged, 10);
}

TEST(Bias, OfHalfAPerCentIsFound) {
  NoisyPictures maker(128, 6);
  for (int i = 0; i < 10; ++i) {
    const BiasEstimate bias = estimate(maker, {.factor = 1.005});
    EXPECT_TRUE(bias.detected);
    EXPECT_NEAR(bias.mean_ratio.value, 0.005, 4.5 * bias.mean_ratio.standard_error);
  }
}

TEST(Bias, IsRecoveredWithItsSize) {
  NoisyPictures maker(64, 7);
  double squares = 0;
  for (std::size_t i = 0; i < maker.pixels(); ++i)
    for (int c = 0; c < 3; ++c) squares += 0.01 * maker.truth(i, c) * maker.truth(i, c);
  const double rms = std::sqrt(squares / (3.0 * static_cast<double>(maker.pixels())));
  const BiasEstimate bias = estimate(maker, {.factor = 1.1});
  EXPECT_TRUE(bias.detected);
  EXPECT_LT(bias.rms_low(), rms);
  EXPECT_GT(bias.rms_high(), rms);
  EXPECT_NEAR(bias.rms(), rms, 0.05 * rms);
}

TEST(Bias, RoundingIsNone) {
  NoisyPictures maker(64, 8);
  EXPECT_FALSE(estimate(maker, {.sigma = 0, .reference_sigma = 0, .factor = 1 + 1e-8}).detected);
  EXPECT_TRUE(estimate(maker, {.sigma = 0, .reference_sigma = 0, .factor = 1.0001}).detected);
}

TEST(Bias, NeedsTwoSeedsAndAReferenceOfKnownNoise) {
  NoisyPictures maker(4, 9);
  Reference reference = to_reference(join_halves(maker.picture(0.1), maker.picture(0.1)));
  const PixelMask counted = counted_pixels(reference.picture, {});
  SeedMoments moments;
  moments.add(maker.picture(0.1));
  EXPECT_FALSE(estimate_bias(moments, reference, counted));
  moments.add(maker.picture(0.1));
  EXPECT_TRUE(estimate_bias(moments, reference, counted));
  reference.variance.clear();
  EXPECT_FALSE(estimate_bias(moments, reference, counted));
}

}  // namespace
}  // namespace raytracing
