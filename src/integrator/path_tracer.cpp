#include "raytracing/integrator/path_tracer.h"

#include "path.h"
#include "path_reuse.h"

namespace raytracing {
namespace {

class PlainPathTracer final : public PathTracer {
 public:
  PlainPathTracer(const Scene& scene, const PathOptions& options)
      : scene_(scene), options_(options) {}

  void trace(std::span<PathSample> samples, RayQueries& rays, PathLog& log,
             std::size_t logged) override {
    const PathContext in{scene_, options_, rays};
    for (std::size_t k = 0; k < samples.size(); ++k) {
      PathSample& sample = samples[k];
      PathState path(sample.sampler, k == logged ? log : unwanted_log_);
      path.log.steps.clear();
      sample.radiance = sample.direct = Rgb(0.0f);
      const std::optional<Hit> hit = rays.closest_hit(sample.ray);
      if (!hit) continue;
      begin_at_camera(in, path, sample, *hit);
      const bool goes_on = trace_vertex(in, path);
      sample.direct = path.radiance;
      if (goes_on) trace_path(in, path);
      sample.radiance = path.radiance;
    }
  }

 private:
  const Scene& scene_;
  const PathOptions options_;
  PathLog unwanted_log_;
};

}  // namespace

std::unique_ptr<PathTracer> make_path_tracer(const Scene& scene, const PathOptions& options,
                                             bool shared) {
  if (shared) return std::make_unique<SharedPathTracer>(scene, options);
  return std::make_unique<PlainPathTracer>(scene, options);
}

}  // namespace raytracing
