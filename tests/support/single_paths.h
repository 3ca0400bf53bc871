#pragma once
// One path after the other, for tests of single estimates.

#include <span>

#include "raytracing/integrator/path_tracer.h"

namespace raytracing {

class SinglePaths {
 public:
  SinglePaths(const Scene& scene, const PathOptions& options)
      : options_(options), rays_(scene), tracer_(make_path_tracer(scene, options_, false)) {}
  SinglePaths(const SinglePaths&) = delete;

  /// The radiance that arrives along the ray, by one path that shares nothing.
  Rgb radiance(const Ray& ray, const PathSampler& sampler) {
    PathSample sample{sampler, ray};
    tracer_->trace(std::span(&sample, 1), rays_, log_, 0);
    return sample.radiance;
  }

 private:
  const PathOptions options_;
  RayQueries rays_;
  PathLog log_;
  std::unique_ptr<PathTracer> tracer_;
};

}  // namespace raytracing
