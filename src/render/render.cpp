#include "raytracing/render/render.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <mutex>
#include <thread>
#include <tuple>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace raytracing {
namespace {

constexpr std::size_t kNamedSamples = 8;
// The picture is refined in passes, so that one that is stopped early is noisy rather than torn.
constexpr std::uint64_t kSamplesPerPass = 16;

double thread_cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Embree asks for this; slow denormal numbers have no place in a picture.
void flush_denormals() {
#if defined(__SSE__)
  _mm_setcsr(_mm_getcsr() | 0x8040);  // flush to zero, denormals are zero
#endif
}

bool is_finite(const Rgb& c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

// Keeps the few that come first in the picture, whatever thread found them.
void keep_first(std::vector<NonFiniteSample>& named) {
  std::sort(named.begin(), named.end(), [](const NonFiniteSample& a, const NonFiniteSample& b) {
    return std::tie(a.y, a.x, a.sample) < std::tie(b.y, b.x, b.sample);
  });
  if (named.size() > kNamedSamples) named.resize(kNamedSamples);
}

// Work of all threads: tile after tile of pass after pass, handed out by a counter.
class Job {
 public:
  Job(const Scene& scene, const RenderOptions& options, const std::atomic<bool>& stop,
      const ProgressCallback& progress, RenderResult& result)
      : scene_(scene),
        options_(options),
        camera_(scene.camera(), options.width, options.height),
        stop_(stop),
        progress_(progress),
        result_(result),
        tiles_x_((options.width + options.tile_size - 1) / options.tile_size),
        tiles_y_((options.height + options.tile_size - 1) / options.tile_size),
        passes_((options.spp + kSamplesPerPass - 1) / kSamplesPerPass),
        passes_done_(static_cast<std::size_t>(tiles_x_) * tiles_y_) {}

  // One thread's share.
  void work() {
    flush_denormals();
    const double start = thread_cpu_seconds();
    Share share(scene_);
    const std::uint64_t tiles = passes_done_.size();
    while (!stop_) {
      const std::uint64_t ticket = next_++;
      if (ticket >= tiles * passes_) break;
      const std::uint64_t tile = ticket % tiles, pass = ticket / tiles;
      // The samples of a pixel are added in order: another thread may still be at the last pass. It
      // always ends it, since `stop_` is looked at only before taking a ticket.
      for (std::uint64_t n = passes_done_[tile]; n != pass; n = passes_done_[tile])
        passes_done_[tile].wait(n);
      render_tile(static_cast<int>(tile), pass, share);
      ++passes_done_[tile];
      passes_done_[tile].notify_all();
      report(share);
    }
    std::scoped_lock lock(mutex_);
    result_.rays += share.visibility.counts();
    result_.paths += share.paths;
    result_.non_finite_samples += share.non_finite;
    result_.first_non_finite.insert(result_.first_non_finite.end(), share.named.begin(),
                                    share.named.end());
    result_.cpu_seconds += thread_cpu_seconds() - start;
  }

 private:
  struct Share {
    explicit Share(const Scene& scene) : visibility(scene) {}
    Visibility visibility;
    PathLog log;
    std::uint64_t paths = 0;
    std::uint64_t reported = 0;
    std::uint64_t non_finite = 0;
    std::vector<NonFiniteSample> named;
  };

  void render_tile(int tile, std::uint64_t pass, Share& share) {
    const int x0 = tile % tiles_x_ * options_.tile_size;
    const int y0 = tile / tiles_x_ * options_.tile_size;
    const int x1 = std::min(x0 + options_.tile_size, options_.width);
    const int y1 = std::min(y0 + options_.tile_size, options_.height);
    const std::uint64_t first = pass * kSamplesPerPass;
    const std::uint64_t last = std::min(first + kSamplesPerPass, options_.spp);
    const std::uint64_t group_size =
        options_.replicates > 1 ? options_.spp / options_.replicates : 1;
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        Film::Pixel pixel = result_.film.at(x, y);
        for (std::uint64_t sample = first; sample < last; ++sample)
          pixel.add(finite_sample(x, y, sample, share), group_size);
        result_.film.at(x, y) = pixel;
      }
  }

  Rgb finite_sample(int x, int y, std::uint64_t sample, Share& share) {
    ++share.paths;
    const Rgb radiance =
        trace_sample(scene_, camera_, options_, x, y, sample, share.visibility, share.log);
    if (is_finite(radiance)) return radiance;
    ++share.non_finite;
    share.named.push_back({x, y, sample});
    keep_first(share.named);
    return Rgb(0.0f);
  }

  void report(Share& share) {
    done_ += share.paths - share.reported;
    share.reported = share.paths;
    if (!progress_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return;
    progress_(done_, options_.spp * options_.width * options_.height);
  }

  const Scene& scene_;
  const RenderOptions& options_;
  const Camera camera_;
  const std::atomic<bool>& stop_;
  const ProgressCallback& progress_;
  RenderResult& result_;
  const int tiles_x_, tiles_y_;
  const std::uint64_t passes_;
  std::vector<std::atomic<std::uint64_t>> passes_done_;  // of each tile
  std::atomic<std::uint64_t> next_{0};
  std::atomic<std::uint64_t> done_{0};
  std::mutex mutex_;
};

}  // namespace

RenderResult render(const Scene& scene, const RenderOptions& options,
                    const std::atomic<bool>& stop, const ProgressCallback& progress) {
  RenderResult result(Film(options.width, options.height));
  const auto start = std::chrono::steady_clock::now();
  {
    Job job(scene, options, stop, progress, result);
    std::vector<std::jthread> threads;
    for (int i = 0; i < options.threads; ++i) threads.emplace_back([&job] { job.work(); });
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  result.render_seconds = wall.count();
  result.complete =
      result.paths == options.spp * static_cast<std::uint64_t>(options.width) * options.height;
  keep_first(result.first_non_finite);
  return result;
}

// One body for the picture and for --replay: copies made for the one or the other could round
// differently.
#if defined(__GNUC__) && !defined(__clang__)
[[gnu::noipa]]
#endif
Rgb trace_sample(const Scene& scene, const Camera& camera, const RenderOptions& options, int x,
                 int y, std::uint64_t sample, Visibility& visibility, PathLog& log) {
  std::uint64_t replicate = 0;
  if (options.replicates > 1) {
    const std::uint64_t group_size = options.spp / options.replicates;
    replicate = sample / group_size;
    sample %= group_size;
  }
  PathSampler sampler(options.sampler, options.seed, static_cast<std::uint32_t>(x),
                      static_cast<std::uint32_t>(y), sample, replicate);
  const Vec2 jitter = sampler.pair(0);
  const Ray ray = camera.ray(static_cast<float>(x) + jitter.x, static_cast<float>(y) + jitter.y);
  return shade(scene, options.shade, ray, sampler, visibility, log);
}

}  // namespace raytracing
