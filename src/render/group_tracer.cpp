#include "group_tracer.h"

#include <algorithm>

#include "raytracing/render/threads.h"

namespace raytracing {
namespace {

// A sample's place among the replicates of its pixel.
struct ReplicateSample {
  std::uint64_t replicate = 0;
  std::uint64_t sample;  // within the replicate

  ReplicateSample(const RenderOptions& options, std::uint64_t index) : sample(index) {
    if (options.replicates <= 1) return;
    const std::uint64_t replicate_size = options.spp / options.replicates;
    replicate = index / replicate_size;
    sample = index % replicate_size;
  }
};

}  // namespace

PixelGroups groups_of(const RenderOptions& options, std::uint64_t sample) {
  const ReplicateSample s(options, sample);
  return PixelGroups(options.width, options.height, group_edge(options), options.seed, s.sample,
                     s.replicate);
}

GroupTracer::GroupTracer(const Scene& scene, const Camera& camera, const RenderOptions& options,
                         bool keeps_first_hits)
    : camera_(camera),
      options_(options),
      sampler_(options.sampler, options.seed),
      rays_(scene),
      tracer_(make_path_tracer(scene, options.path, shares_paths(options))),
      first_hits_(keeps_first_hits ? PathTracer::kMaxSamples : 0) {}

void GroupTracer::trace(const PixelGroups& groups, const PixelGroups::Place& place,
                        std::uint64_t sample, const PixelGroups::Pixel& logged) {
  groups.pixels(place, pixels_);
  samples_.clear();
  const ReplicateSample s(options_, sample);
  for (const auto& [x, y] : pixels_) {
    samples_.push_back({sampler_.path(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                      s.sample, s.replicate),
                        {}});
    const Vec2 jitter = samples_.back().sampler.pair(0);
    samples_.back().ray =
        camera_.ray(static_cast<float>(x) + jitter.x, static_cast<float>(y) + jitter.y);
  }
  if (samples_.empty()) return;
  if (!first_hits_.empty()) keep_first_hits();
  const auto found = std::find(pixels_.begin(), pixels_.end(), logged);
  tracer_->trace(samples_, rays_, log_,
                 found == pixels_.end() ? 0 : static_cast<std::size_t>(found - pixels_.begin()));
}

void GroupTracer::keep_first_hits() {
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    first_hits_[k].reset();
    samples_[k].first_hit = &first_hits_[k];
  }
}

TracedSample trace_sample(const Scene& scene, const RenderOptions& options,
                          const SampleIndex& index) {
  const FlushedDenormals flushed;
  const Camera camera(scene.camera(), options.width, options.height);
  const PixelGroups::Pixel pixel{index.x, index.y};
  const PixelGroups groups = groups_of(options, index.sample);
  GroupTracer tracer(scene, camera, options);
  tracer.trace(groups, groups.place_of(pixel), index.sample, pixel);
  const auto pixels = tracer.pixels();
  const auto own = std::find(pixels.begin(), pixels.end(), pixel) - pixels.begin();
  return {tracer.radiance(static_cast<std::size_t>(own)), tracer.log(), tracer.rays().counts()};
}

}  // namespace raytracing
