#pragma once

#include <cstdint>
#include <optional>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/integrator/path_log.h"

namespace raytracing {

struct ShadeOptions {
  const DirectMethod* method = nullptr;
  /// Surfaces that a path may be reflected at, >= 1: 1 = direct light only; empty = any number.
  std::optional<std::uint32_t> max_depth;
  int line_rays = 4;  ///< see DirectQuery
};

/// The radiance that arrives along `ray`, estimated by one path. Pair 0 of the sampler is the
/// caller's, for the position within the pixel. `log` receives each vertex: always, since a second
/// body without it could round differently, and a replay would not be the sample of the picture.
Rgb shade(const Scene& scene, const ShadeOptions& options, const Ray& ray, PathSampler& sampler,
          Visibility& visibility, PathLog& log);

}  // namespace raytracing
