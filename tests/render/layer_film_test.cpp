// The sums behind layers.

#include "raytracing/render/layer_film.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/layers.h"

namespace raytracing {
namespace {

std::vector<const Layer*> named(const std::vector<std::string>& names) {
  std::vector<const Layer*> result;
  for (const std::string& name : names) result.push_back(find_layer(name));
  return result;
}

/// One pixel and its layers, which get the same samples.
struct OnePixel {
  explicit OnePixel(const std::vector<std::string>& names) : layers(named(names), 1, 1) {}

  void add(const LayerSample& sample, std::uint64_t replicate_size = 1) {
    pixel.add(sample.radiance, replicate_size);
    layers.add(0, 0, pixel, sample);
  }
  std::vector<float> values() const {
    std::vector<float> result;
    layers.append_values(0, 0, pixel, result);
    return result;
  }

  Film::Pixel pixel;
  LayerFilm layers;
};

const std::optional<FirstHit> kNothing;
const std::optional<FirstHit> kNear{FirstHit{{1, 2, 3}, {0, 1, 0}, Rgb(0.5f), 4}};
const std::optional<FirstHit> kFar{FirstHit{{3, 6, 9}, {1, 0, 0}, Rgb(0.25f), 8}};

using Values = std::vector<float>;

TEST(LayerFilm, OnlySampledLayersSumSamples) {
  EXPECT_FALSE(LayerFilm().sums_samples());
  EXPECT_FALSE(OnePixel({"variance", "samples"}).layers.sums_samples());
  EXPECT_TRUE(OnePixel({"variance", "indirect"}).layers.sums_samples());
  EXPECT_TRUE(OnePixel({"depth"}).layers.sums_samples());
}

TEST(LayerFilm, ChannelsAreInTheOrderAskedFor) {
  const OnePixel one({"samples", "depth", "direct"});
  EXPECT_EQ(one.layers.channels(),
            (std::vector<std::string>{"samples", "depth.Z", "direct.R", "direct.G", "direct.B"}));
  EXPECT_TRUE(one.layers.has("depth"));
  EXPECT_FALSE(one.layers.has("variance"));
}

TEST(LayerFilm, MeansAreOverSamplesOrOverHits) {
  OnePixel one({"albedo", "depth", "position", "samples"});
  EXPECT_EQ(one.values(), (Values{0, 0, 0, INFINITY, 0, 0, 0, 0})) << "no sample";
  one.add({Rgb(1.0f), Rgb(0.0f), kNothing});
  EXPECT_EQ(one.values(), (Values{0, 0, 0, INFINITY, 0, 0, 0, 1})) << "no hit";
  one.add({Rgb(1.0f), Rgb(0.0f), kNear});
  one.add({Rgb(1.0f), Rgb(0.0f), kFar});
  one.add({Rgb(1.0f), Rgb(0.0f), kNothing});
  EXPECT_EQ(one.values(), (Values{0.1875f, 0.1875f, 0.1875f, 6, 2, 4, 6, 4}));
}

TEST(LayerFilm, ReplicatesThatAreNotCompleteAreLeftOutAsInTheFilm) {
  OnePixel one({"direct", "indirect", "depth", "samples"});
  const LayerSample dim{{1, 2, 3}, {1, 1, 1}, kNear}, bright{{9, 9, 9}, {4, 5, 6}, kFar};
  one.add(dim, 2);
  EXPECT_EQ(one.values(), (Values{1, 1, 1, 0, 1, 2, 4, 1})) << "there is nothing else";
  one.add(dim, 2);
  one.add(bright, 2);
  EXPECT_EQ(one.values(), (Values{1, 1, 1, 0, 1, 2, 4, 2}));
  one.add(bright, 2);
  EXPECT_EQ(one.values(), (Values{2.5f, 3, 3.5f, 2.5f, 2.5f, 2.5f, 6, 4}));
  EXPECT_EQ(one.pixel.mean(), DVec3(5, 5.5, 6));
}

TEST(LayerFilm, VarianceIsThatOfTheFilm) {
  OnePixel one({"variance"});
  one.add({{1, 2, 3}, Rgb(0.0f), kNothing});
  EXPECT_EQ(one.values(), (Values{INFINITY, INFINITY, INFINITY})) << "of one sample, unknown";
  one.add({{3, 2, 7}, Rgb(0.0f), kNothing});
  EXPECT_EQ(one.values(), (Values{1, 0, 4}));
}

TEST(LayerFilm, ValuesThatAreNotFiniteAreLeftOut) {
  OnePixel one({"position", "normal"});
  const std::optional<FirstHit> broken{FirstHit{{NAN, 0, 0}, {0, INFINITY, 0}, Rgb(0.0f), 1}};
  one.add({Rgb(0.0f), Rgb(0.0f), broken});
  EXPECT_EQ(one.values(), (Values{0, 0, 0, 0, 0, 0}));
  one.add({Rgb(0.0f), Rgb(0.0f), kNear});
  EXPECT_EQ(one.values(), (Values{1, 2, 3, 0, 1, 0}));
}

}  // namespace
}  // namespace raytracing
