#pragma once

#include <memory>
#include <span>
#include <vector>

#include "raytracing/integrator/path_tracer.h"
#include "raytracing/render/pixel_groups.h"
#include "raytracing/render/render.h"

namespace raytracing {

/// The groups of sample number `sample`.
PixelGroups groups_of(const RenderOptions& options, std::uint64_t sample);

/// Traces one sample of all pixels of one group after the other; one per thread. A picture and a
/// replay of one of its samples both come from here.
class GroupTracer {
 public:
  /// With `keeps_first_hits`, first_hit() tells what the rays of the camera met.
  GroupTracer(const Scene& scene, const Camera& camera, const RenderOptions& options,
              bool keeps_first_hits = false);

  /// Traces sample number `sample` of the group at `place`; `groups` are those of the sample.
  /// log() becomes that of the pixel `logged` if it belongs to the group. Fastest when samples of
  /// one group follow each other.
  void trace(const PixelGroups& groups, const PixelGroups::Place& place, std::uint64_t sample,
             const PixelGroups::Pixel& logged = {-1, -1});

  /// The group's pixels. radiance(k), direct(k) and first_hit(k) are the results of pixels()[k];
  /// see PathSample.
  std::span<const PixelGroups::Pixel> pixels() const { return pixels_; }
  const Rgb& radiance(std::size_t k) const { return samples_[k].radiance; }
  const Rgb& direct(std::size_t k) const { return samples_[k].direct; }
  const std::optional<FirstHit>& first_hit(std::size_t k) const { return first_hits_[k]; }
  const PathLog& log() const { return log_; }
  const RayQueries& rays() const { return rays_; }

 private:
  void keep_first_hits();

  const Camera& camera_;
  const RenderOptions& options_;
  PixelSampler sampler_;
  RayQueries rays_;
  std::unique_ptr<PathTracer> tracer_;
  std::vector<PixelGroups::Pixel> pixels_;
  std::vector<PathSample> samples_;
  std::vector<std::optional<FirstHit>> first_hits_;  // of kMaxSamples samples, or of none
  PathLog log_;
};

}  // namespace raytracing
