// The layers of the first hits of whole pictures, against closed forms, and what all layers owe the
// picture.

#include "raytracing/render/layers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "support/layers.h"
#include "support/rooms.h"
#include "support/scenes.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

RenderOptions options_of(int width, int height, std::uint64_t spp) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.spp = spp;
  options.path.method = &direct_method("solid-angle");
  options.path.max_depth = 1;
  options.seed = 5;
  return options;
}

TEST(Layers, TableHasDifferentNamesAndAtMostThreeLetters) {
  std::set<std::string> channels{"R", "G", "B"};
  for (const Layer& layer : layers()) {
    EXPECT_EQ(find_layer(layer.name), &layer);
    EXPECT_LE(layer.letters.size(), 3u) << layer.name;
    EXPECT_FALSE(layer.meaning.empty() || layer.meaning.ends_with('.')) << layer.name;
    for (const std::string& channel : layer.channels())
      EXPECT_TRUE(channels.insert(channel).second) << channel;
  }
  EXPECT_EQ(find_layer("depth")->channels(), std::vector<std::string>{"depth.Z"});
  EXPECT_EQ(find_layer("samples")->channels(), std::vector<std::string>{"samples"});
  EXPECT_EQ(find_layer("normal")->channels(),
            (std::vector<std::string>{"normal.X", "normal.Y", "normal.Z"}));
  EXPECT_EQ(find_layer("no such"), nullptr);
}

/// The floor y = 0, seen obliquely by a camera of 50 degrees.
struct Floor {
  static constexpr int kWidth = 16, kHeight = 12;
  static constexpr double kHalf = 40;  // of the floor's edge
  const Rgb reflectance{0.25f, 0.5f, 0.75f};

  Scene scene() const {
    SceneMaker maker;
    const auto half = static_cast<float>(kHalf);
    maker.add_polygon(parallelogram(Vec3(0.0f), {0, 0, half}, {half, 0, 0}),
                      maker.add_surface(Diffuse{reflectance}));
    maker.description.camera = {Vec3(eye), {0, 1, 0}, {0, 1, 0}, 50};
    return maker.build();
  }
  /// The direction through the point (x, y) of the picture, not of unit length.
  DVec3 direction(double x, double y) const {
    const DVec3 forward = normalize(DVec3(0, 1, 0) - eye);
    const DVec3 right = normalize(cross(forward, DVec3(0, 1, 0))), up = cross(right, forward);
    const double pixel = 2 * std::tan(25 * std::numbers::pi / 180) / kHeight;
    return forward + pixel * ((x - kWidth / 2.0) * right - (y - kHeight / 2.0) * up);
  }
  /// The ray's parameter at the plane of the floor; negative where it never gets there.
  double parameter(double x, double y) const { return -eye.y / direction(x, y).y; }
  bool meets(double x, double y) const {
    const DVec3 p = position(x, y);
    return parameter(x, y) > 0 && std::max(std::abs(p.x), std::abs(p.z)) < kHalf;
  }
  DVec3 position(double x, double y) const { return eye + parameter(x, y) * direction(x, y); }
  double distance(double x, double y) const { return length(position(x, y) - eye); }
  /// How many corners of the pixel lie on the floor.
  int corners_on_floor(int x, int y) const {
    return meets(x, y) + meets(x + 1, y) + meets(x, y + 1) + meets(x + 1, y + 1);
  }

  const DVec3 eye{1, 3, 6};
};

/// The mean over the pixel (x, y) of a function of the point of the picture.
template <class F>
double pixel_mean(const F& f, int x, int y) {
  return integrate2(f, x, x + 1, y, y + 1, 2);
}

// The mean over 256 Sobol' points is that over the pixel to a thousandth of how much it varies.
TEST(Layers, FloorIsThatOfTheClosedForm) {
  const Floor floor;
  const LayeredPicture picture =
      render_layers(floor.scene(), options_of(Floor::kWidth, Floor::kHeight, 256));
  int inside = 0, outside = 0;
  for (int y = 0; y < Floor::kHeight; ++y)
    for (int x = 0; x < Floor::kWidth; ++x) {
      const DVec3 p = picture.at3(x, y, "position", "XYZ");
      if (floor.corners_on_floor(x, y) == 0) {
        ++outside;
        EXPECT_EQ(picture.at(x, y, "depth.Z"), INFINITY);
        for (const DVec3& none :
             {p, picture.at3(x, y, "normal", "XYZ"), picture.at3(x, y, "albedo")})
          EXPECT_EQ(none, DVec3(0.0));
      }
      if (floor.corners_on_floor(x, y) < 4) continue;
      ++inside;
      EXPECT_EQ(picture.at3(x, y, "albedo"), DVec3(floor.reflectance));
      EXPECT_EQ(picture.at3(x, y, "normal", "XYZ"), DVec3(0, 1, 0));
      const DVec3 across = floor.position(x, y) - floor.position(x + 1, y + 1);
      const double tolerance = 1e-3 * length(across) + 1e-5 * length(p);
      const auto distance = [&](double s, double t) { return floor.distance(s, t); };
      EXPECT_NEAR(picture.at(x, y, "depth.Z"), pixel_mean(distance, x, y), tolerance);
      for (int i = 0; i < 3; ++i) {
        const auto coordinate = [&](double s, double t) { return floor.position(s, t)[i]; };
        EXPECT_NEAR(p[i], pixel_mean(coordinate, x, y), tolerance) << x << ", " << y;
      }
    }
  EXPECT_GT(inside, 80);
  EXPECT_GT(outside, 20);
}

// The left half of the middle pixel sees a wall at the distance 10 and the right half nothing.
TEST(Layers, MeansAtAnEdge) {
  SceneMaker maker;
  const Rgb rho(0.5f, 0.25f, 1);
  maker.add_polygon(parallelogram({-50, 0, -10}, {50, 0, 0}, {0, 50, 0}),
                    maker.add_surface(Diffuse{rho}));
  maker.description.camera = {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 2};
  const Scene scene = maker.build();
  const LayeredPicture picture = render_layers(scene, options_of(3, 3, 64));
  EXPECT_NEAR(picture.at(1, 1, "depth.Z"), 10, 1e-3) << "the mean over the rays that hit";
  EXPECT_NEAR(picture.at(1, 1, "position.Z"), -10, 1e-5);
  EXPECT_NEAR(picture.at(1, 1, "position.X"), -10 * std::tan(std::numbers::pi / 180) / 6, 1e-3);
  EXPECT_EQ(picture.at3(1, 1, "normal", "XYZ"), DVec3(0, 0, 0.5)) << "not made longer";
  EXPECT_EQ(picture.at3(1, 1, "albedo"), 0.5 * DVec3(rho));
  EXPECT_EQ(picture.at(2, 1, "depth.Z"), INFINITY);
  EXPECT_EQ(picture.at(0, 1, "normal.Z"), 1);
  EXPECT_EQ(picture.at(1, 1, "samples"), 64);
}

TEST(Layers, DoNotChangeABitOfThePicture) {
  const Scene scene = metal_ball_room();
  for (const DirectMethod& method : direct_methods())
    for (const int reuse : {1, 4, 16}) {
      RenderOptions options = options_of(23, 17, 3);
      options.path = {&method, {}};
      options.reuse = reuse;
      const RenderResult bare = render_all(scene, options);
      EXPECT_FALSE(bare.layers.sums_samples());
      options.layers = all_layers();
      const RenderResult layered = render_all(scene, options);
      EXPECT_EQ(differing_pixels(bare.film, layered.film), 0) << method.name << ", " << reuse;
      EXPECT_EQ(bare.rays.closest, layered.rays.closest);
      EXPECT_EQ(bare.rays.shadow, layered.rays.shadow);
    }
}

TEST(Layers, DependNeitherOnThreadsNorOnTiles) {
  const Scene scene = metal_ball_room();
  for (const int reuse : {1, 4, 16}) {
    RenderOptions options = options_of(37, 23, 6);
    options.path.max_depth = 4;
    options.reuse = reuse;
    options.replicates = 3;
    const LayeredPicture first = render_layers(scene, options);
    for (const auto& [threads, tile_size] : {std::pair{2, 16}, {5, 3}, {5, 33}}) {
      options.threads = threads;
      options.tile_size = tile_size;
      EXPECT_EQ(first.image.values, render_layers(scene, options).image.values)
          << "reuse " << reuse << ", " << threads << " threads, tile size " << tile_size;
    }
  }
}

TEST(Layers, FirstHitsDependNeitherOnReuseNorOnTheMethod) {
  const Scene scene = metal_ball_room();
  RenderOptions options = options_of(23, 17, 4);
  options.path.max_depth = 3;
  const LayeredPicture one = render_layers(scene, options);
  options.reuse = 16;
  options.path.method = &direct_method("line");
  const LayeredPicture other = render_layers(scene, options);
  for (int y = 0; y < 17; ++y)
    for (int x = 0; x < 23; ++x) {  // rays are traced one by one or in eights, and rounded so
      EXPECT_LT(length(one.at3(x, y, "albedo") - other.at3(x, y, "albedo")), 1e-6);
      EXPECT_LT(length(one.at3(x, y, "normal", "XYZ") - other.at3(x, y, "normal", "XYZ")), 1e-4);
      EXPECT_LT(length(one.at3(x, y, "position", "XYZ") - other.at3(x, y, "position", "XYZ")),
                1e-5);
      EXPECT_NEAR(one.at(x, y, "depth.Z"), other.at(x, y, "depth.Z"), 1e-5);
    }
}

}  // namespace
}  // namespace raytracing
