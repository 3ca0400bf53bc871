#include "raytracing/study/metrics/z_scores.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// One row of grey pixels with one variance for the three channels.
struct GreyPixel {
  float value, variance;
};

ImageData row(const std::vector<GreyPixel>& pixels) {
  ImageData image{static_cast<int>(pixels.size()),
                  1,
                  {"R", "G", "B", "variance.R", "variance.G", "variance.B"},
                  {},
                  {}};
  for (const GreyPixel& p : pixels)
    for (const float v : {p.value, p.value, p.value, p.variance, p.variance, p.variance})
      image.values.push_back(v);
  return image;
}

// By hand: z = -2, 4, 1.9 and 0.
TEST(ZScores, AddTheVariances) {
  const auto z = z_scores(row({{1, 9}, {4, 0.5f}, {1.9f, 1}, {7, 1}}),
                          row({{11, 16}, {0, 0.5f}, {0, 0}, {7, 0}}));
  ASSERT_TRUE(z.has_value());
  EXPECT_EQ(z->scores, 12u);
  EXPECT_DOUBLE_EQ(z->share_196, 0.5);
  EXPECT_DOUBLE_EQ(z->share_3, 0.25);
  EXPECT_NEAR(z->mean, (-2 + 4 + 1.9) / 4, 1e-7);
  EXPECT_NEAR(z->rms, std::sqrt((4 + 16 + 1.9 * 1.9) / 4), 1e-7);
  EXPECT_EQ(z->no_variance_equal + z->no_variance_different + z->not_finite, 0u);
}

TEST(ZScores, MakeAPicture) {
  const ImageData z = z_score_picture(row({{1, 9}, {4, 0.5f}, {1, 0}, {1, kNan}}),
                                      row({{11, 16}, {0, 0.5f}, {1, 0}, {1, 1}}));
  EXPECT_EQ(z.width, 4);
  EXPECT_EQ(z.channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ((std::vector<float>(z.values.begin(), z.values.begin() + 6)),
            (std::vector<float>{-2, -2, -2, 4, 4, 4}));
  for (std::size_t i = 6; i < 12; ++i) EXPECT_TRUE(std::isnan(z.values[i])) << i;
  const ImageData exact{2, 1, {"R", "G", "B"}, {0, 0, 0, 0, 0, 0}, {}};
  EXPECT_THROW(z_score_picture(exact, exact), InputError);
}

TEST(ZScores, CountWhatHasNone) {
  const auto z = z_scores(row({{1, 0}, {1, 0}, {kNan, 1}, {1, kNan}, {1, 1}, {1, -1}, {3, 1}}),
                          row({{1, 0}, {2, 0}, {1, 1}, {1, 1}, {1, kInfinity}, {1, 2}, {3, 0}}));
  ASSERT_TRUE(z.has_value());
  EXPECT_EQ(z->no_variance_equal, 3u);
  EXPECT_EQ(z->no_variance_different, 3u);
  EXPECT_EQ(z->not_finite, 12u);
  EXPECT_EQ(z->scores, 3u);
  EXPECT_EQ(z->rms, 0);
}

TEST(ZScores, TakeAPictureWithoutLayersAsExact) {
  const ImageData exact{2, 1, {"R", "G", "B"}, {0, 0, 0, 0, 0, 0}, {}};
  EXPECT_FALSE(z_scores(exact, exact).has_value());
  const ImageData noisy = row({{1, 4}, {1, 4}});
  for (const auto& z : {z_scores(exact, noisy), z_scores(noisy, exact)})
    EXPECT_EQ(z.value().rms, 0.5);
}

TEST(ZScores, HeedTheMask) {
  const ImageData exact{2, 1, {"R", "G", "B"}, {0, 0, 0, 0, 0, 0}, {}};
  EXPECT_EQ(z_scores(exact, row({{1, 4}, {5, 4}}), {1, 0}).value().rms, 0.5);
  const auto none = z_scores(exact, row({{1, 4}, {5, 4}}), {0, 0});
  EXPECT_EQ(none->scores, 0u);
  EXPECT_TRUE(std::isnan(none->share_196));
  EXPECT_THROW(z_scores(exact, exact, {1}), InputError);
}

// Normal noise of known variance: both shares are binomial, checked at 5 standard deviations.
TEST(ZScores, HaveTheExpectedShares) {
  std::mt19937_64 random(7);
  std::normal_distribution<float> normal;
  constexpr int kPixels = 100000;
  ImageData test{kPixels, 1, {"R", "G", "B", "variance.R", "variance.G", "variance.B"}, {}, {}};
  ImageData reference = test;
  for (int i = 0; i < kPixels; ++i) {
    const auto append = [&](ImageData& image, float variance) {
      for (int c = 0; c < 3; ++c) image.values.push_back(2 + std::sqrt(variance) * normal(random));
      for (int c = 0; c < 3; ++c) image.values.push_back(variance);
    };
    append(test, 0.3f);
    append(reference, 0.1f + 0.1f * static_cast<float>(i % 3));
  }
  const ZScores z = z_scores(test, reference).value();
  const double count = 3.0 * kPixels;
  const auto close = [&](double share, double expected) {
    EXPECT_NEAR(share, expected, 5 * std::sqrt(expected / count));
  };
  const ExpectedScores expected = expected_scores(test, reference);
  close(z.share_196, expected.share_196);
  close(z.share_3, expected.share_3);
  EXPECT_NEAR(z.mean, 0, 5 / std::sqrt(count));
  EXPECT_NEAR(z.rms, 1, 5 / std::sqrt(2 * count));
}

// python3 -c "from scipy.stats import norm, t; print(2 * norm.sf(1.96), 2 * norm.sf(3));
//   print(2 * t.sf(1.96, 14), 2 * t.sf(3, 14), 2 * t.sf(1.96, 7))"
TEST(ZScores, ExpectationsFollowTheHeaders) {
  ImageData test, reference;
  test.channels = {"R", "G", "B", "variance.R", "variance.G", "variance.B"};
  reference.channels = {"R", "G", "B"};
  const auto set = [](ImageData& image, std::int64_t spp, std::int64_t replicates,
                      const char* sampler) {
    image.metadata = {{"spp", spp}, {"replicates", replicates}, {"sampler", std::string(sampler)}};
  };
  const ExpectedScores unknown = expected_scores(test, reference);
  EXPECT_EQ(unknown.degrees, 0);
  EXPECT_NEAR(unknown.share_196, 0.04999579, 1e-8);
  EXPECT_NEAR(unknown.share_3, 0.00269980, 1e-8);
  EXPECT_FALSE(unknown.overstated);
  set(test, 64, 8, "sobol");
  set(reference, 64, 8, "sobol");
  EXPECT_EQ(expected_scores(test, reference).degrees, 7);  // the reference has no variance
  EXPECT_NEAR(expected_scores(test, reference).share_196, 0.09081970, 1e-8);
  reference.channels = test.channels;
  EXPECT_EQ(expected_scores(test, reference).degrees, 14);
  EXPECT_NEAR(expected_scores(test, reference).share_196, 0.07021027, 1e-8);
  EXPECT_NEAR(expected_scores(test, reference).share_3, 0.00955151, 1e-8);
  EXPECT_NEAR(expected_scores(test, reference).rms, std::sqrt(14 / 12.0), 1e-12);
  EXPECT_FALSE(expected_scores(test, reference).overstated);
  set(reference, 64, 1, "sobol");
  EXPECT_TRUE(expected_scores(test, reference).overstated);
  set(reference, 4096, 1, "independent");
  EXPECT_EQ(expected_scores(test, reference).degrees, 0);
  EXPECT_FALSE(expected_scores(test, reference).overstated);
}

}  // namespace
}  // namespace raytracing
