// Closed rooms whose walls all emit e and reflect rho, everywhere the same: the radiance after k
// reflections is e (1 + rho + ... + rho^k) on every ray, and e / (1 - rho) in the limit.

#include <gtest/gtest.h>

#include "raytracing/integrator/path_tracer.h"
#include "support/p_values.h"
#include "support/scenes.h"
#include "support/single_paths.h"

namespace raytracing {
namespace {

constexpr SamplerKind kSamplers[]{SamplerKind::independent, SamplerKind::sobol};
const Rgb kEmitted(1.0f, 2.0f, 0.5f);
// Solid angles are known to about 3e-7 in absolute terms; relative to the means here it is less.
constexpr double kRounding = 2e-5;

Scene furnace(PolygonMesh (*room)(const Diffuse&, SceneMaker&), const Diffuse& wall) {
  SceneMaker maker;
  maker.description.meshes.push_back(room(wall, maker));
  return maker.build();
}

PolygonMesh box(const Diffuse& wall, SceneMaker& maker) {
  return inward_box(1, maker.add_surface(wall, kEmitted));
}

PolygonMesh icosphere(const Diffuse& wall, SceneMaker& maker) {
  return inward_icosphere(3, maker.add_surface(wall, kEmitted));
}

double expected(double e, double rho, std::optional<std::uint32_t> max_depth) {
  const double rest = max_depth ? std::pow(rho, *max_depth + 1.0) : 0;
  return e * (1 - rest) / (1 - rho);
}

/// Statistics by channel of `samples` paths from the middle of the room; `spp` paths make a pixel.
/// The spread is that between single paths for independent numbers, and between the means of pixels
/// for Sobol' points. A ray of `direction` 0 goes anywhere.
std::array<RunningStats, 3> measure(const Scene& scene, const PathOptions& options,
                                    SamplerKind kind, int samples, int spp,
                                    const Vec3& direction = Vec3(0.0f)) {
  std::array<RunningStats, 3> stats;
  SinglePaths paths(scene, options);
  TestRandom random(5);
  for (int pixel = 0; pixel < samples / spp; ++pixel) {
    DVec3 sum(0.0);
    for (int i = 0; i < spp; ++i) {
      const PathSampler sampler(kind, 2, pixel, 0, i);
      const Vec3 d = is_black(direction) ? random.direction() : direction;
      const DVec3 radiance(paths.radiance({Vec3(0.1f, 0.2f, -0.1f), d}, sampler));
      if (kind == SamplerKind::independent)
        for (int c = 0; c < 3; ++c) stats[c].add(radiance[c]);
      sum += radiance;
    }
    if (kind == SamplerKind::sobol)
      for (int c = 0; c < 3; ++c) stats[c].add(sum[c] / spp);
  }
  return stats;
}

void add_channels(PValues& p_values, const std::string& name,
                  const std::array<RunningStats, 3>& stats, const Rgb& rho,
                  std::optional<std::uint32_t> max_depth, double rounding) {
  for (int c = 0; c < 3; ++c) {
    const double truth = expected(double{kEmitted[c]}, double{rho[c]}, max_depth);
    p_values.add(name + ", channel " + std::to_string(c),
                 mean_p_value(stats[c], truth, rounding * truth));
  }
}

std::string name_of(const DirectMethod& method, SamplerKind kind) {
  return std::string(method.name) + ", " + std::string(to_string(kind));
}

/// line-ratio is biased by occlusion only, and nothing occludes in a convex room.
bool must_hold(const DirectMethod& method) {
  return method.unbiased || method.name == "line-ratio";
}

// A density by area has heavy tails where two faces meet: the radiance r apart across an edge is
// sampled with values ~ 1/r^2 and probability ~ r^3, an infinite variance. A box, with its right
// angles, is no place for it. In the icosphere of 1,280 faces the share of the light that travels
// between points of different faces less than r apart is about 0.025 r, and the closest pair of
// 60,000 has r = 0.02: what a run misses in this way is 5e-4 of the mean, below its own spread.
constexpr double kTail = 5e-4;

TEST(Furnace, IcosphereHasTheSumOfTheSeriesAtEveryDepth) {
  const Diffuse wall{Rgb(0.8f, 0.5f, 0.2f)};
  const Scene scene = furnace(icosphere, wall);
  PValues p_values;
  for (const DirectMethod& method : direct_methods()) {
    if (!must_hold(method)) continue;
    for (const SamplerKind kind : kSamplers)
      for (const std::optional<std::uint32_t> max_depth :
           std::initializer_list<std::optional<std::uint32_t>>{1, 2, 3, 4, 5, 9, std::nullopt}) {
        const auto stats = measure(scene, {&method, max_depth}, kind, 25'000, 64);
        add_channels(p_values,
                     name_of(method, kind) + ", depth " +
                         (max_depth ? std::to_string(*max_depth) : "unlimited"),
                     stats, wall.reflectance, max_depth, kTail);
      }
  }
  p_values.expect_all();
}

// Walls of a single reflectance, so that the weights of roulette cannot hide in one channel.
TEST(Furnace, IcosphereHasItsLimitForDarkAndBrightWalls) {
  PValues p_values;
  for (const float rho : {0.5f, 0.8f}) {
    const Scene scene = furnace(icosphere, {Rgb(rho)});
    for (const DirectMethod& method : direct_methods()) {
      if (!must_hold(method)) continue;
      for (const SamplerKind kind : kSamplers)
        add_channels(p_values, name_of(method, kind),
                     measure(scene, {&method, std::nullopt}, kind, 40'000, 64), Rgb(rho),
                     std::nullopt, kTail);
    }
  }
  p_values.expect_all();
}

// Six lights that are rectangles. The ray meets a wall far from the edges, and one reflection keeps
// the receiver there: all methods have a bounded variance.
TEST(Furnace, BoxHasOneReflectionAwayFromItsEdges) {
  const Diffuse wall{Rgb(0.8f, 0.5f, 0.2f)};
  const Scene scene = furnace(box, wall);
  PValues p_values;
  for (const DirectMethod& method : direct_methods()) {
    if (!must_hold(method)) continue;
    for (const SamplerKind kind : kSamplers)
      for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(-0.3f, 0.9f, 0.2f), Vec3(0.1f, 0.4f, -1)})
        add_channels(p_values, name_of(method, kind),
                     measure(scene, {&method, 1}, kind, 100'000, 64, direction), wall.reflectance,
                     1, kRounding);
  }
  p_values.expect_all();
}

// Everywhere in the box, by the method whose density never falls far below the integrand.
TEST(Furnace, BoxHasTheSumOfTheSeriesBySolidAngle) {
  const Diffuse wall{Rgb(0.8f, 0.5f, 0.2f)};
  const Scene scene = furnace(box, wall);
  const DirectMethod* method = &direct_method("solid-angle");
  PValues p_values;
  for (const SamplerKind kind : kSamplers)
    for (const std::optional<std::uint32_t> max_depth :
         std::initializer_list<std::optional<std::uint32_t>>{1, 3, 6, std::nullopt})
      add_channels(p_values, name_of(*method, kind),
                   measure(scene, {method, max_depth}, kind, 100'000, 64), wall.reflectance,
                   max_depth, kRounding);
  p_values.expect_all();
}

// Paths that share their second vertices: the rays of a group leave from points far apart, so that
// many second vertices lie in each other's view at all angles.
TEST(Furnace, IcosphereHasTheSumOfTheSeriesWithSharedPaths) {
  const Diffuse wall{Rgb(0.8f, 0.5f, 0.2f)};
  const Scene scene = furnace(icosphere, wall);
  PValues p_values;
  for (const DirectMethod& method : direct_methods()) {
    if (!must_hold(method)) continue;
    for (const std::optional<std::uint32_t> max_depth :
         std::initializer_list<std::optional<std::uint32_t>>{2, 3, 5, std::nullopt}) {
      const PathOptions options{&method, max_depth};
      const auto tracer = make_path_tracer(scene, options, true);
      RayQueries rays(scene);
      PathLog log;
      TestRandom random(6);
      std::array<RunningStats, 3> stats;
      for (std::uint32_t i = 0; i < 3'000; ++i) {
        std::vector<PathSample> samples;
        for (std::uint32_t k = 0; k < 12; ++k)
          samples.push_back({PathSampler(SamplerKind::independent, 3, i, k, 0),
                             {Vec3(0.1f, 0.2f, -0.1f), random.direction()}});
        tracer->trace(samples, rays, log, 0);
        DVec3 mean(0.0);
        for (const PathSample& sample : samples) mean += DVec3(sample.radiance) / 12.0;
        for (int c = 0; c < 3; ++c) stats[c].add(mean[c]);
      }
      add_channels(p_values,
                   std::string(method.name) + ", shared, depth " +
                       (max_depth ? std::to_string(*max_depth) : "unlimited"),
                   stats, wall.reflectance, max_depth, kTail);
    }
  }
  p_values.expect_all();
}

// The mean must not depend on the number of samples that a pixel takes.
TEST(Furnace, IsAsBrightWithFewSamplesPerPixelAsWithMany) {
  const Diffuse wall{Rgb(0.8f, 0.5f, 0.2f)};
  const Scene scene = furnace(icosphere, wall);
  PValues p_values;
  for (const DirectMethod& method : direct_methods()) {
    if (!must_hold(method)) continue;
    for (const SamplerKind kind : kSamplers)
      for (const int spp : {1, 3, 100})
        add_channels(p_values, name_of(method, kind) + ", spp " + std::to_string(spp),
                     measure(scene, {&method, std::nullopt}, kind, 15'000, spp), wall.reflectance,
                     std::nullopt, kTail);
  }
  p_values.expect_all();
}

}  // namespace
}  // namespace raytracing
