// The noise floor of a reference, and which files are none.

#include "raytracing/study/metrics/reference.h"

#include <gtest/gtest.h>

#include "raytracing/io/errors.h"
#include "raytracing/math/numeric.h"
#include "study/noisy_pictures.h"
#include "support/p_values.h"
#include "support/temp_dir.h"

namespace raytracing {
namespace {

// The squared error of the reference is known from its making; relMSE, whose weights hold the
// reference's noise, is measured from the truth itself.
TEST(NoiseFloor, IsWhatAPerfectPictureMeasures) {
  constexpr double kSigma = 0.05;
  constexpr int kRepetitions = 100;
  NoisyPictures maker(64, 11);
  double mse = 0;  // of the mean of two halves, in expectation
  for (std::size_t i = 0; i < maker.pixels(); ++i)
    for (int c = 0; c < 3; ++c)
      mse += maker.variance(i, c, kSigma) / 2 / (3.0 * static_cast<double>(maker.pixels()));
  const ImageData truth = maker.picture(0);
  RunningStats z, relmse_difference;
  for (int repeat = 0; repeat < kRepetitions; ++repeat) {
    const ImageData a = maker.picture(kSigma), b = maker.picture(kSigma);
    const Reference reference = to_reference(join_halves(a, b));
    const auto floor = noise_floor(reference, counted_pixels(reference.picture, {}));
    ASSERT_TRUE(floor);
    z.add((floor->mse.value - mse) / floor->mse.standard_error);
    const double measured = error_metrics(truth, reference.picture).relmse;
    relmse_difference.add(floor->relmse.value / measured - 1);
    EXPECT_LT(floor->relmse.standard_error, 0.1 * floor->relmse.value);
  }
  PValues tests;
  tests.add("MSE", normal_p_value(z.mean() * std::sqrt(kRepetitions)));
  const double squares = (kRepetitions - 1) * z.variance() + kRepetitions * square(z.mean());
  const double p = gamma_q(0.5 * kRepetitions, 0.5 * squares);
  tests.add("standard error of MSE", 2 * std::min(p, 1 - p));
  tests.add("relMSE", mean_p_value(relmse_difference, 0, 0.003));
  tests.expect_all();
}

TEST(NoiseFloor, MaskChoosesThePixels) {
  ImageData a, b;
  for (ImageData* image : {&a, &b}) {
    image->width = 3;
    image->height = 1;
    image->channels = {"R", "G", "B"};
  }
  a.values = {1, 1, 1, 2, 2, 2, 3, 3, 3};
  b.values = {1, 1, 1, 4, 4, 4, 9, 9, 9};
  const Reference reference = to_reference(join_halves(a, b));
  EXPECT_EQ(reference.picture.values[9], 3.0f);  // the second pixel's mean
  const auto floor = noise_floor(reference, counted_pixels(reference.picture, {1, 1, 0}));
  EXPECT_DOUBLE_EQ(floor->mse.value, 0.5);
  EXPECT_DOUBLE_EQ(floor->mse.standard_error, 0.5);
  EXPECT_DOUBLE_EQ(floor->relmse.value, 0.5 / 9.01);
}

TEST(Reference, TooFewPixelsAreRefused) {
  NoisyPictures maker(2, 1);
  ImageData picture = maker.picture(0);
  EXPECT_THROW(counted_pixels(picture, {1, 0, 0, 0}), InputError);
  EXPECT_THROW(counted_pixels(picture, {1, 1}), InputError);
  picture.values[3] = INFINITY;
  EXPECT_EQ(counted_pixels(picture, {}), (PixelMask{1, 0, 1, 1}));
}

TEST(Reference, VarianceLayersCountWhenTheSamplesAreIndependent) {
  NoisyPictures maker(2, 1);
  ImageData picture = join_halves(maker.picture(0.1), maker.picture(0.1));
  picture.channels = {"R", "G", "B", "variance.R", "variance.G", "variance.B", "x", "y", "z"};
  EXPECT_TRUE(to_reference(picture).variance.empty());
  picture.metadata = {{"sampler", std::string("sobol")}};
  EXPECT_TRUE(to_reference(picture).variance.empty());
  picture.metadata = {{"sampler", std::string("independent")}};
  const Reference reference = to_reference(picture);
  ASSERT_EQ(reference.variance.size(), 4u);
  EXPECT_EQ(reference.variance[1].y, picture.values[9 + 4]);
  picture.metadata = {{"sampler", std::string("sobol")}, {"replicates", std::int64_t{4}}};
  EXPECT_EQ(to_reference(picture).variance.size(), 4u);
  picture.metadata[1].second = std::int64_t{1};
  EXPECT_TRUE(to_reference(picture).variance.empty());
}

// The noise of means over pixels does not follow from variances of pixels that share paths.
TEST(Reference, SharedPathsMakeTheNoiseUnknown) {
  NoisyPictures maker(2, 1);
  ImageData picture = join_halves(maker.picture(0.1), maker.picture(0.1));
  picture.channels = {"R", "G", "B", "variance.R", "variance.G", "variance.B", "x", "y", "z"};
  picture.metadata = {{"sampler", std::string("independent")},
                      {"pixel_correlation", std::string("none: independent")}};
  EXPECT_EQ(to_reference(picture).variance.size(), 4u);
  picture.metadata[1].second = std::string("errors of pixels less than 8 apart are alike");
  const Reference reference = to_reference(picture);
  EXPECT_TRUE(reference.variance.empty());
  EXPECT_EQ(reference.variance_source,
            "not known: neighbouring pixels share paths; --reuse 1 avoids it");
}

TEST(Reference, VarianceThatIsNoneMakesTheNoiseUnknown) {
  NoisyPictures maker(2, 1);
  for (const float bad : {INFINITY, NAN, -1.0f}) {
    ImageData picture = join_halves(maker.picture(0.1), maker.picture(0.1));
    picture.channels = {"R", "G", "B", "variance.R", "variance.G", "variance.B", "x", "y", "z"};
    picture.metadata = {{"sampler", std::string("independent")}};
    picture.values[9 + 5] = bad;
    const Reference reference = to_reference(picture);
    EXPECT_TRUE(reference.variance.empty());
    EXPECT_EQ(reference.variance_source,
              "not known: the variance of some pixels is no finite number");
  }
}

class ReferenceFile : public ::testing::Test {
 protected:
  ReferenceFile() : picture_(NoisyPictures(2, 3).picture(0.1)) {
    picture_.metadata = {{"scene_hash", std::string("00000000000000ff")},
                         {"max_depth", std::string("1")},
                         {"seed", std::int64_t{7}},
                         {"light_sampling", std::string("line")},
                         {"light_sampling_biased", false},
                         {"complete", true}};
  }

  void set(const std::string& name, const std::string& value) {
    for (auto& [key, old] : picture_.metadata)
      if (key == name) old = value;
  }

  /// What reading it says; "" when it is taken.
  std::string refusal(const char* format = "exr") {
    const std::string path = folder_.write("r.exr", encode_image(picture_, format));
    try {
      read_reference(path, terms_);
      return "";
    } catch (const InputError& error) {
      return std::string(error.what()).substr(path.size());
    }
  }

  TempDir folder_;
  ImageData picture_;
  ReferenceTerms terms_{2, 2, 255, "1", {5, 6}};
};

TEST_F(ReferenceFile, OfThisChartIsTaken) { EXPECT_EQ(refusal(), ""); }

TEST_F(ReferenceFile, WithoutHeaderIsTakenAndWhatWasNotCheckedIsTold) {
  const auto unchecked = [this] {
    return read_reference(folder_.write("r.exr", encode_image(picture_, "exr")), terms_).unchecked;
  };
  EXPECT_EQ(unchecked(), "");
  picture_.metadata.clear();
  EXPECT_EQ(unchecked(), "scene_hash, light_sampling_biased, max_depth, complete");
}

TEST_F(ReferenceFile, ThatWasStoppedIsRefused) {
  set("complete", "false");
  EXPECT_EQ(refusal(), ": not a reference: its rendering was stopped early");
}

TEST_F(ReferenceFile, OfAnotherSizeIsRefused) {
  terms_.width = 3;
  EXPECT_EQ(refusal(), ": not a reference for this chart: its size is 2x2, not 3x2");
}

TEST_F(ReferenceFile, OfAnotherSceneIsRefused) {
  set("scene_hash", "0000000000000001");
  EXPECT_EQ(refusal(),
            ": not a reference for this chart: its scene hash is 0000000000000001, "
            "not 00000000000000ff");
}

TEST_F(ReferenceFile, OfAnotherDepthIsRefused) {
  set("max_depth", "unlimited");
  EXPECT_EQ(refusal(), ": not a reference for this chart: its maximal depth is unlimited, not 1");
}

TEST_F(ReferenceFile, OfABiasedMethodIsRefused) {
  set("light_sampling_biased", "true");
  EXPECT_EQ(refusal(), ": not a reference: its method line is biased");
}

TEST_F(ReferenceFile, OfATestRunIsRefused) {
  terms_.seeds.push_back(7);
  EXPECT_EQ(refusal(), ": not a reference: its seed 7 is that of a test run");
}

TEST_F(ReferenceFile, InPngIsRefused) {
  EXPECT_EQ(refusal("png"),
            ": 8 bits are too few for a reference; it must hold floats, as an EXR file does");
}

}  // namespace
}  // namespace raytracing
