#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "raytracing/integrator/path_tracer.h"
#include "raytracing/render/film.h"
#include "raytracing/render/layer_film.h"
#include "raytracing/scene/description.h"

namespace raytracing {

struct RenderOptions {
  int width = 784;
  int height = 784;
  std::uint64_t spp = 16;
  /// Groups of each pixel's samples, each with its own scrambles; divides spp. Group r holds the
  /// samples r spp / replicates and on. With 2 or more, the variances are those of the groups.
  std::uint64_t replicates = 1;
  /// Edge of the groups of pixels that share paths: 1 = none do; 2, 4, 8 or 16. See PixelGroups.
  int reuse = 1;
  PathOptions path;
  SamplerKind sampler = SamplerKind::sobol;
  std::uint64_t seed = 0;
  int threads = 1;
  int tile_size = 16;
  std::vector<const Layer*> layers;  ///< that the result has beside the film, each once
};

/// Returns the edge of the groups of pixels that share paths: 1 also where there is nothing to
/// share.
inline int group_edge(const RenderOptions& options) {
  return options.path.max_depth == 1u ? 1 : options.reuse;
}

/// Returns whether samples share paths.
inline bool shares_paths(const RenderOptions& options) { return group_edge(options) > 1; }

/// Returns whether the scene must be built with its occluder tree.
inline bool needs_occluders(const RenderOptions& options) {
  return options.path.method->asks_segments || shares_paths(options);
}

/// Sample number `sample` of the pixel (x, y); rows count from the top.
struct SampleIndex {
  int x, y;
  std::uint64_t sample;
};

/// A sample whose radiance was infinite or not a number. It counts as black.
struct NonFiniteSample {
  SampleIndex index;
  NonFiniteCause cause;
};

struct RenderResult {
  explicit RenderResult(Film empty) : film(std::move(empty)) {}

  Film film;
  LayerFilm layers;
  RayCounts rays;
  std::uint64_t paths = 0;
  std::uint64_t non_finite_samples = 0;
  /// Indexed by NonFiniteCause. All that are found at once in a group count with the cause of the
  /// group's first one.
  std::array<std::uint64_t, kNonFiniteCauses> non_finite_by_cause{};
  std::vector<NonFiniteSample> first_non_finite;  ///< a few of them, in order of (y, x, sample)
  int threads = 1;            ///< that worked; fewer than asked for when the system allows no more
  double render_seconds = 0;  ///< wall clock
  double cpu_seconds = 0;     ///< of all threads
  bool complete = true;       ///< false when stopped early
};

/// Is called from time to time, by one thread at a time, with the samples done and the samples in
/// all.
using ProgressCallback = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// Renders the picture by `options.threads` threads, or as many as can be started. The result does
/// not depend on their number nor on the tile size. When `stop` becomes true, returns soon with
/// what there is. Throws what a method or `progress` throws, and std::invalid_argument for options
/// without a method or with a tile size below 1.
RenderResult render(const Scene& scene, const RenderOptions& options, const std::atomic<bool>& stop,
                    const ProgressCallback& progress);

/// One sample as render() takes it, and how it came about.
struct TracedSample {
  Rgb radiance;
  PathLog log;
  RayCounts rays;  ///< of the whole group of pixels that the sample shares paths with
};
/// Traces one sample again: `index` lies within the picture and below options.spp.
TracedSample trace_sample(const Scene& scene, const RenderOptions& options,
                          const SampleIndex& index);

}  // namespace raytracing
