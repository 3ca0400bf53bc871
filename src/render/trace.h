#pragma once
// How one sample, or one group of samples that share paths, is traced.

#include <span>

#include "raytracing/integrator/reuse.h"
#include "raytracing/render/pixel_groups.h"
#include "raytracing/render/render.h"

namespace raytracing {

/// While it lives, denormal numbers count as 0 in this thread: Embree asks for it, and slow numbers
/// have no place in a picture.
class FlushedDenormals {
 public:
  FlushedDenormals();
  ~FlushedDenormals();
  FlushedDenormals(const FlushedDenormals&) = delete;
  FlushedDenormals& operator=(const FlushedDenormals&) = delete;

 private:
  unsigned before_;
};

/// The groups of sample number `sample`.
PixelGroups groups_of(const RenderOptions& options, std::uint64_t sample);

/// Traces samples that share nothing; one per thread.
class SampleTracer {
 public:
  SampleTracer(const Scene& scene, const Camera& camera, const RenderOptions& options)
      : scene_(scene),
        camera_(camera),
        options_(options),
        sampler_(options.sampler, options.seed) {}

  /// The radiance of one sample. Fastest when the samples of a pixel follow each other.
  Rgb trace(int x, int y, std::uint64_t sample, Visibility& visibility, PathLog& log);

 private:
  const Scene& scene_;
  const Camera& camera_;
  const RenderOptions& options_;
  PixelSampler sampler_;
};

/// Traces groups of samples; one per thread.
class GroupTracer {
 public:
  GroupTracer(const Scene& scene, const Camera& camera, const RenderOptions& options)
      : camera_(camera), options_(options), group_(scene, options.shade) {}

  /// The pixels of the group; pixels()[k] has the radiance radiance(k). The log is that of the
  /// pixel `logged` where it belongs to the group.
  void trace(const PixelGroups& groups, const PixelGroups::Place& place, std::uint64_t sample,
             const PixelGroups::Pixel& logged, Visibility& visibility, PathLog& log);
  std::span<const PixelGroups::Pixel> pixels() const { return pixels_; }
  const Rgb& radiance(std::size_t k) const { return paths_[k].radiance; }

 private:
  const Camera& camera_;
  const RenderOptions& options_;
  PathGroup group_;
  std::vector<PixelGroups::Pixel> pixels_;
  std::vector<SharedPath> paths_;
};

}  // namespace raytracing
