#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/integrator/first_hit.h"
#include "raytracing/integrator/path_log.h"

namespace raytracing {

struct PathOptions {
  const DirectMethod* method = nullptr;
  /// Surfaces that a path may be reflected at, >= 1: 1 = direct light only; empty = any number.
  std::optional<std::uint32_t> max_depth;
  int line_rays = 4;  ///< see DirectQuery
};

/// One sample of one pixel. Pair 0 of the sampler is the caller's, for the position in the pixel.
struct PathSample {
  PathSampler sampler;
  Ray ray;             ///< of the camera
  Rgb radiance{0.0f};  ///< the result: the radiance that arrives along the ray, estimated
  /// The part of the radiance without a surface between the first hit and the light: the emission
  /// that the ray meets and the direct light there, that which the bounce finds included.
  Rgb direct{0.0f};
  /// Where given, an empty one that receives what the ray meets, if anything.
  std::optional<FirstHit>* first_hit = nullptr;
};

/// Estimates the radiance of samples by tracing their paths. One per thread; it keeps its memory.
class PathTracer {
 public:
  static constexpr std::size_t kMaxSamples = 256;

  virtual ~PathTracer() = default;

  /// Sets the results of 1 to kMaxSamples samples. `log` receives what makes the radiance of
  /// samples[logged]. It is always written: a second body without it could round differently, and a
  /// replayed sample would not be that of the picture.
  virtual void trace(std::span<PathSample> samples, RayQueries& rays, PathLog& log,
                     std::size_t logged) = 0;
};

/// A tracer of samples that share nothing or, with `shared`, of samples that use each other's paths
/// (Bekaert, Sbert & Halton 2002). Each sample then has the same expectation, far less variance,
/// and errors like those of its group; its log holds its first vertex, the light that its own
/// bounce met, and each second vertex of the group that shines on it, with a black `throughput`
/// and in `direct` all the light that comes by way of that vertex. Sharing needs a max_depth of 2
/// or more: below, there is nothing to share.
std::unique_ptr<PathTracer> make_path_tracer(const Scene& scene, const PathOptions& options,
                                             bool shared);

}  // namespace raytracing
