// Lights are sampled by power with probability 0.9 and uniformly with probability 0.1.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "support/scenes.h"

namespace raytracing {
namespace {

// Makes square lights of these areas and equal radiance, one unit apart.
Scene scene_with(std::initializer_list<float> areas) {
  SceneMaker maker;
  const std::uint32_t light = maker.add_surface(Diffuse{Rgb(0.5f)}, Rgb(1.0f));
  float place = 0;
  for (const float area : areas) {
    const float half = std::sqrt(area) / 2;
    maker.add_polygon(parallelogram({place, 0, 0}, {half, 0, 0}, {0, half, 0}), light);
    place += 1;
  }
  return maker.build();
}

TEST(LightChoice, ATenthIsUniform) {
  const Scene scene = scene_with({0.001f, 0.1f, 0.899f});
  ASSERT_EQ(scene.lights().size(), 3u);
  EXPECT_NEAR(scene.light_pmf(0), 0.9 * 0.001 + 0.1 / 3, 1e-6);
  EXPECT_NEAR(scene.light_pmf(1), 0.9 * 0.1 + 0.1 / 3, 1e-6);
  EXPECT_NEAR(scene.light_pmf(2), 0.9 * 0.899 + 0.1 / 3, 1e-6);
}

TEST(LightChoice, FrequenciesEqualThePmf) {
  const Scene scene = scene_with({0.001f, 0.1f, 0.899f});
  constexpr int kChoices = 1 << 16;
  std::array<int, 3> counts{};
  for (int i = 0; i < kChoices; ++i) {
    const auto chosen = scene.choose_light((static_cast<float>(i) + 0.5f) / kChoices);
    EXPECT_EQ(chosen.pmf, scene.light_pmf(chosen.index));
    ++counts[chosen.index];
  }
  for (std::uint32_t i = 0; i < counts.size(); ++i)
    EXPECT_NEAR(counts[i] / static_cast<double>(kChoices), scene.light_pmf(i), 2.0 / kChoices);
}

TEST(LightChoice, OneLightIsCertain) {
  const Scene scene = scene_with({0.25f});
  EXPECT_EQ(scene.light_pmf(0), 1);
  EXPECT_EQ(scene.choose_light(0.7f).index, 0u);
}

}  // namespace
}  // namespace raytracing
