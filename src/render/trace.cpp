#include "trace.h"

#include <algorithm>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace raytracing {
namespace {

// A sample's number within its replicate.
struct Numbered {
  std::uint64_t sample;
  std::uint64_t replicate = 0;

  Numbered(const RenderOptions& options, std::uint64_t index) : sample(index) {
    if (options.replicates <= 1) return;
    const std::uint64_t replicate_size = options.spp / options.replicates;
    replicate = index / replicate_size;
    sample = index % replicate_size;
  }
};

// The camera ray of a sample.
Ray camera_ray(const Camera& camera, PathSampler& sampler, int x, int y) {
  const Vec2 jitter = sampler.pair(0);
  return camera.ray(static_cast<float>(x) + jitter.x, static_cast<float>(y) + jitter.y);
}

}  // namespace

#if defined(__SSE__)
FlushedDenormals::FlushedDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
FlushedDenormals::~FlushedDenormals() { _mm_setcsr(before_); }
#else
FlushedDenormals::FlushedDenormals() : before_(0) {}
FlushedDenormals::~FlushedDenormals() = default;
#endif

PixelGroups groups_of(const RenderOptions& options, std::uint64_t sample) {
  const Numbered n(options, sample);
  return PixelGroups(options.width, options.height, options.reuse, options.seed, n.sample,
                     n.replicate);
}

// One body for the picture and for --replay: copies made for the one or the other could round
// differently.
#if defined(__GNUC__) && !defined(__clang__)
[[gnu::noipa]]
#endif
void GroupTracer::trace(const PixelGroups& groups, const PixelGroups::Place& place,
                        std::uint64_t sample, const PixelGroups::Pixel& logged,
                        Visibility& visibility, PathLog& log) {
  groups.pixels(place.column, place.row, place.index, pixels_);
  paths_.clear();
  const Numbered n(options_, sample);
  for (const PixelGroups::Pixel& pixel : pixels_) {
    PathSampler sampler(options_.sampler, options_.seed, static_cast<std::uint32_t>(pixel.x),
                        static_cast<std::uint32_t>(pixel.y), n.sample, n.replicate);
    const Ray ray = camera_ray(camera_, sampler, pixel.x, pixel.y);
    paths_.push_back({ray, sampler});
  }
  if (paths_.empty()) return;
  const auto found = std::find(pixels_.begin(), pixels_.end(), logged);
  group_.shade(paths_, visibility, log,
               found == pixels_.end() ? 0 : static_cast<std::size_t>(found - pixels_.begin()));
}

#if defined(__GNUC__) && !defined(__clang__)
[[gnu::noipa]]
#endif
Rgb SampleTracer::trace(int x, int y, std::uint64_t sample, Visibility& visibility, PathLog& log) {
  const Numbered n(options_, sample);
  PathSampler sampler = sampler_.path(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                      n.sample, n.replicate);
  const Ray ray = camera_ray(camera_, sampler, x, y);
  return shade(scene_, options_.shade, ray, sampler, visibility, log);
}

Rgb trace_sample(const Scene& scene, const Camera& camera, const RenderOptions& options, int x,
                 int y, std::uint64_t sample, Visibility& visibility, PathLog& log) {
  const FlushedDenormals flushed;
  if (!shares_paths(options))
    return SampleTracer(scene, camera, options).trace(x, y, sample, visibility, log);
  const PixelGroups groups = groups_of(options, sample);
  GroupTracer tracer(scene, camera, options);
  tracer.trace(groups, groups.place_of({x, y}), sample, {x, y}, visibility, log);
  const auto pixels = tracer.pixels();
  const auto own = std::find(pixels.begin(), pixels.end(), PixelGroups::Pixel{x, y});
  return tracer.radiance(static_cast<std::size_t>(own - pixels.begin()));
}

}  // namespace raytracing
