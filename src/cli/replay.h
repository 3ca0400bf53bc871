#pragma once

#include <string>

#include "render_options.h"

namespace raytracing {

/// Traces the one sample and tells its vertices and contributions. Throws UsageError when the pixel
/// or sample lies outside the picture that `options` describes. `origin` is what was subtracted
/// from the scene file's positions.
std::string replay_text(const Scene& scene, const RenderOptions& options,
                        const RenderArguments::Replay& replay, const Vec3& origin);

}  // namespace raytracing
