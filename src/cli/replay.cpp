#include "replay.h"

#include <fmt/format.h>

#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

template <class V>
std::string text(const V& v) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
}

}  // namespace

std::string replay_text(const Scene& scene, const RenderOptions& options,
                        const RenderArguments::Replay& replay, const Vec3& origin) {
  if (replay.x >= options.width || replay.y >= options.height || replay.sample >= options.spp)
    throw UsageError(fmt::format("--replay: {},{},{} lies outside {}x{} pixels and {} spp",
                                 replay.x, replay.y, replay.sample, options.width, options.height,
                                 options.spp));
  const Camera camera(scene.camera(), options.width, options.height);
  Visibility visibility(scene);
  PathLog log;
  const Rgb radiance =
      trace_sample(scene, camera, options, replay.x, replay.y, replay.sample, visibility, log);
  std::string out =
      fmt::format("pixel {},{} sample {} seed {} {} {}\n", replay.x, replay.y, replay.sample,
                  options.seed, to_string(options.sampler), options.shade.method->name);
  if (shares_paths(options))
    out += fmt::format(
        "paths are shared by groups of {0}x{0}: vertices of throughput 0 are those "
        "behind the first bounces of the group; 'direct' is all the light that this "
        "sample gets by way of them\n",
        options.reuse);
  for (std::size_t i = 0; i < log.steps.size(); ++i) {
    const PathLog::Step& s = log.steps[i];
    out += fmt::format(
        "vertex {} at {} normal {}\n  throughput {}\n  emitted {}{}\n  direct {}\n"
        "  goes on with probability {:.9g}\n",
        i + 1, text(DVec3(s.position) + DVec3(origin)), text(s.normal), text(s.throughput),
        text(s.emitted), s.light == kNone ? "" : fmt::format(" (light {})", s.light),
        text(s.direct), s.survival);
  }
  if (!is_finite(radiance))
    out += fmt::format("not finite: {}\n", to_string(non_finite_cause(log)));
  const RayCounts& asked = visibility.counts();
  return out + fmt::format(
                   "radiance {}; {} closest-hit rays, {} shadow rays, {} segment queries, "
                   "{} shaft queries\n",
                   text(radiance), asked.closest, asked.shadow, asked.segments, asked.shafts);
}

}  // namespace raytracing
