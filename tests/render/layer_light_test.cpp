// The layers direct and indirect: the parts of the picture that they should be.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/layers.h"
#include "support/p_values.h"
#include "support/scenes.h"

namespace raytracing {
namespace {

/// A room with a metal ball before a metal wall, so that BSDF sampling finds a part of the direct
/// light. The camera sees the lamp, too, unless its target lies low.
Scene room(const Rgb& Le = {5.0f, 4.0f, 3.0f}, float target_y = 0.1f) {
  SceneMaker maker;
  const auto wall = maker.add_surface(Diffuse{Rgb(0.7f, 0.5f, 0.3f)});
  const auto metal = maker.add_surface(GgxConductor{Rgb(0.9f), 0.16f});
  maker.description.meshes.push_back(inward_box(1, wall));
  maker.add_polygon(parallelogram({0, 0.95f, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}),
                    maker.add_surface(Diffuse{Rgb(0.0f)}, Le));
  maker.add_sphere({0.2f, -0.6f, -0.2f}, 0.4f, metal);
  maker.add_polygon(parallelogram({0, 0, -0.9f}, {0.9f, 0, 0}, {0, 0.9f, 0}), metal);
  maker.description.camera = {{0.0f, 0.1f, 0.95f}, {0.0f, target_y, 0.0f}, {0.0f, 1.0f, 0.0f}, 90};
  return maker.build();
}

RenderOptions options_of(int reuse, const DirectMethod& method = direct_method("solid-angle")) {
  RenderOptions options;
  options.width = 8;
  options.height = 6;
  options.spp = 4;
  options.reuse = reuse;
  options.path.method = &method;
  options.seed = 3;
  return options;
}

/// direct + indirect = picture, to the rounding of floats, and neither is negative.
void expect_parts_of_picture(const LayeredPicture& picture) {
  for (int y = 0; y < picture.image.height; ++y)
    for (int x = 0; x < picture.image.width; ++x) {
      const DVec3 direct = picture.at3(x, y, "direct"), indirect = picture.at3(x, y, "indirect");
      const DVec3 radiance = picture.radiance(x, y);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(direct[c] + indirect[c], radiance[c], 0x1p-23 * radiance[c]);
        EXPECT_GE(direct[c], 0);
        EXPECT_GE(indirect[c], 0);
      }
    }
}

TEST(LayerLight, AllIsDirectAtDepthOne) {
  const Scene scene = room();
  for (const DirectMethod& method : direct_methods())
    for (const int reuse : {1, 16}) {
      RenderOptions options = options_of(reuse, method);
      options.path.max_depth = 1;
      const LayeredPicture picture = render_layers(scene, options);
      for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 8; ++x) {
          EXPECT_EQ(picture.at3(x, y, "direct"), picture.radiance(x, y)) << method.name;
          EXPECT_EQ(picture.at3(x, y, "indirect"), DVec3(0.0)) << method.name;
        }
    }
}

// Direct light takes the same random numbers whatever comes after it. Rays that are traced in
// eights are rounded in another way than single ones, and a few pass an edge on its other side.
TEST(LayerLight, DirectIsThePictureOfDepthOneSampleBySample) {
  const Scene scene = room();
  for (const DirectMethod& method : direct_methods())
    for (const int reuse : {1, 4, 16})
      for (const std::optional<std::uint32_t> depth : {std::optional(2u), {}}) {
        RenderOptions options = options_of(reuse, method);
        options.width = 24;
        options.height = 18;
        options.path.max_depth = depth;
        const LayeredPicture deep = render_layers(scene, options);
        options.path.max_depth = 1;
        const LayeredPicture flat = render_layers(scene, options);
        int differing = 0;
        for (int y = 0; y < 18; ++y)
          for (int x = 0; x < 24; ++x) {
            const DVec3 direct = deep.at3(x, y, "direct"), expected = flat.radiance(x, y);
            const double tolerance = reuse == 1 ? 0 : 1e-3;
            differing += length(direct - expected) > tolerance * length(expected);
          }
        EXPECT_LE(differing, reuse == 1 ? 0 : 4) << method.name << ", reuse " << reuse;
        expect_parts_of_picture(deep);
      }
}

// By other random numbers, pixel by pixel and as a mean. The lamp itself is out of sight: the noise
// of pixels at its edge would hide the rest.
TEST(LayerLight, DirectHasTheExpectationOfThePictureOfDepthOne) {
  const Scene scene = room({5.0f, 4.0f, 3.0f}, -0.26f);
  PValues pixels, means;
  for (const DirectMethod& method : direct_methods())
    for (const int reuse : {1, 16}) {
      RenderOptions options = options_of(reuse, method);
      options.spp = 8;
      constexpr std::size_t kPixels = 48;  // and one more for their mean
      std::vector<RunningStats> deep(kPixels + 1), flat(kPixels + 1);
      const auto add = [&](std::vector<RunningStats>& to, const std::string& channel) {
        const LayeredPicture picture = render_layers(scene, options);
        double sum = 0;
        for (std::size_t k = 0; k < kPixels; ++k) {
          const float value = picture.at(static_cast<int>(k) % 8, static_cast<int>(k) / 8, channel);
          to[k].add(value);
          sum += value;
        }
        to[kPixels].add(sum / kPixels);
      };
      for (std::uint64_t i = 0; i < 100; ++i) {
        options.seed = 2 * i;
        options.path.max_depth = 3;
        add(deep, "direct.G");
        options.seed = 2 * i + 1;
        options.path.max_depth = 1;
        add(flat, "G");
      }
      for (std::size_t k = 0; k <= kPixels; ++k)
        (k < kPixels ? pixels : means)
            .add(fmt::format("{}, reuse {}, pixel {}", method.name, reuse, k),
                 same_mean_p_value(deep[k], flat[k], 1e-5 * flat[k].mean()));
    }
  pixels.expect_all();
  means.expect_all();
}

// In a closed room whose walls emit 1 and reflect rho, all rays carry the sum of rho^k: the first
// two terms directly, the others indirectly.
TEST(LayerLight, PartsOfTheFurnaceAreTheTermsOfTheSeries) {
  constexpr double rho = 0.5;
  SceneMaker maker;
  maker.description.meshes.push_back(
      inward_box(1, maker.add_surface(Diffuse{Rgb(0.5f)}, Rgb(1.0f))));
  maker.description.camera = {{0.2f, 0.1f, 0.6f}, {0.0f, -0.1f, 0.0f}, {0.0f, 1.0f, 0.0f}, 70};
  const Scene scene = maker.build();
  PValues p;
  for (const int reuse : {1, 16}) {
    RunningStats direct, indirect;
    RenderOptions options = options_of(reuse);
    options.sampler = SamplerKind::independent;
    for (options.seed = 0; options.seed < 100; ++options.seed) {
      const LayeredPicture picture = render_layers(scene, options);
      double direct_sum = 0, indirect_sum = 0;
      for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 8; ++x) {
          direct_sum += picture.at(x, y, "direct.R");
          indirect_sum += picture.at(x, y, "indirect.R");
        }
      direct.add(direct_sum / 48);
      indirect.add(indirect_sum / 48);
    }
    p.add("direct, reuse " + std::to_string(reuse), mean_p_value(direct, 1 + rho));
    p.add("indirect, reuse " + std::to_string(reuse),
          mean_p_value(indirect, rho * rho / (1 - rho)));
    EXPECT_LT(direct.standard_error(), 0.01);
    EXPECT_LT(indirect.standard_error(), 0.01);
  }
  p.expect_all();
}

TEST(LayerLight, PartsOfAStoppedPictureAreThoseOfItsCompleteReplicates) {
  const Scene scene = room();
  for (const int reuse : {1, 4}) {
    RenderOptions options = options_of(reuse);
    options.width = options.height = 40;
    options.spp = 60;
    options.replicates = 3;
    options.tile_size = 8;
    options.layers = all_layers();
    std::atomic<bool> stop = false;
    const RenderResult part =
        render(scene, options, stop, [&](std::uint64_t done, std::uint64_t total) {
          if (done > total / 2) stop = true;
        });
    EXPECT_FALSE(part.complete);
    const LayeredPicture picture(part);
    expect_parts_of_picture(picture);
    EXPECT_EQ(picture.at(20, 20, "samples"), part.film.at(20, 20).counted);
  }
}

// A sample that is not finite is black in the picture, and so are its parts.
TEST(LayerLight, PartsOfNonFiniteSamplesAreBlack) {
  for (const int reuse : {1, 16}) {
    RenderOptions options = options_of(reuse);
    options.spp = 8;
    options.layers = all_layers();
    const RenderResult result = render_all(room({3e38f, 1e37f, 1}), options);
    EXPECT_GT(result.non_finite_samples, 0u);
    const LayeredPicture picture(result);
    expect_parts_of_picture(picture);
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 8; ++x) EXPECT_TRUE(is_finite(picture.radiance(x, y)));
  }
}

}  // namespace
}  // namespace raytracing
