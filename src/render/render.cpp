#include "raytracing/render/render.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <tuple>

#include "raytracing/math/numeric.h"
#include "raytracing/render/threads.h"
#include "trace.h"

namespace raytracing {
namespace {

constexpr std::size_t kNamedSamples = 8;
// The picture is refined in passes, so that one that is stopped early is noisy rather than torn.
constexpr std::uint64_t kSamplesPerPass = 16;

// The edge of the tiles: of whole groups, where there are groups.
int tile_edge(const RenderOptions& options) {
  if (!shares_paths(options)) return options.tile_size;
  const int group = groups_of(options, 0).tile_edge();
  return (options.tile_size + group - 1) / group * group;
}

// Tiles along an edge of the picture. Shifted ones may need one more.
int tile_count(const RenderOptions& options, int pixels) {
  const int largest_shift = shares_paths(options) ? groups_of(options, 0).tile_edge() - 1 : 0;
  return (pixels + largest_shift + tile_edge(options) - 1) / tile_edge(options);
}

bool is_before(const NonFiniteSample& a, const NonFiniteSample& b) {
  return std::tie(a.y, a.x, a.sample) < std::tie(b.y, b.x, b.sample);
}

// Keeps the few that come first in the picture, whatever thread found them.
void keep_first(std::vector<NonFiniteSample>& named) {
  std::sort(named.begin(), named.end(), is_before);
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
        shared_(shares_paths(options)),
        tile_edge_(tile_edge(options)),
        tiles_x_(tile_count(options, options.width)),
        tiles_y_(tile_count(options, options.height)),
        samples_per_pass_(shared_ ? 1 : kSamplesPerPass),
        passes_((options.spp + samples_per_pass_ - 1) / samples_per_pass_),
        passes_done_(static_cast<std::size_t>(tiles_x_) * tiles_y_) {}

  // One thread's share.
  void work() {
    const double start = thread_cpu_seconds();
    Share share(scene_, camera_, options_);
    const std::uint64_t tiles = passes_done_.size();
    while (!stop_) {
      const std::uint64_t ticket = next_++;
      if (ticket >= tiles * passes_) break;
      const std::uint64_t tile = ticket % tiles, pass = ticket / tiles;
      // The samples of a pixel are added in order: another thread may still be at the last pass. It
      // always ends it, since `stop_` is looked at only before taking a ticket.
      wait_for_pass(static_cast<int>(tile), pass);
      if (shared_)
        render_shared_tile(static_cast<int>(tile), pass, share);
      else
        render_tile(static_cast<int>(tile), pass, share);
      ++passes_done_[tile];
      passes_done_[tile].notify_all();
      report(share);
    }
    std::scoped_lock lock(mutex_);
    result_.rays += share.visibility.counts();
    result_.paths += share.paths;
    for (std::size_t i = 0; i < kNonFiniteCauses; ++i) {
      result_.non_finite_samples += share.non_finite[i];
      result_.non_finite_by_cause[i] += share.non_finite[i];
    }
    result_.first_non_finite.insert(result_.first_non_finite.end(), share.named.begin(),
                                    share.named.end());
    result_.cpu_seconds += thread_cpu_seconds() - start;
  }

 private:
  struct Share {
    Share(const Scene& scene, const Camera& camera, const RenderOptions& options)
        : visibility(scene), samples(scene, camera, options), groups(scene, camera, options) {}
    Visibility visibility;
    SampleTracer samples;
    GroupTracer groups;
    PathLog log;
    std::uint64_t paths = 0;
    std::uint64_t reported = 0;
    std::array<std::uint64_t, kNonFiniteCauses> non_finite{};  // by cause
    std::vector<NonFiniteSample> named;
    std::optional<NonFiniteCause> cause_in_group;  // where the group has had one
  };

  // Waits until the passes before this one are done wherever the tile adds samples. Shifted tiles
  // overlap with their neighbours in the pass before.
  void wait_for_pass(int tile, std::uint64_t pass) {
    const int reach = shared_ ? 1 : 0;
    const int column = tile % tiles_x_, row = tile / tiles_x_;
    for (int y = std::max(row - reach, 0); y <= std::min(row + reach, tiles_y_ - 1); ++y)
      for (int x = std::max(column - reach, 0); x <= std::min(column + reach, tiles_x_ - 1); ++x) {
        std::atomic<std::uint64_t>& done = passes_done_[y * tiles_x_ + x];
        for (std::uint64_t n = done; n < pass; n = done) done.wait(n);
      }
  }

  std::uint64_t replicate_size() const {
    return options_.replicates > 1 ? options_.spp / options_.replicates : 1;
  }

  void render_tile(int tile, std::uint64_t pass, Share& share) {
    const int x0 = tile % tiles_x_ * tile_edge_;
    const int y0 = tile / tiles_x_ * tile_edge_;
    const int x1 = std::min(x0 + tile_edge_, options_.width);
    const int y1 = std::min(y0 + tile_edge_, options_.height);
    const std::uint64_t first = pass * samples_per_pass_;
    const std::uint64_t last = std::min(first + samples_per_pass_, options_.spp);
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        Film::Pixel pixel = result_.film.at(x, y);
        for (std::uint64_t sample = first; sample < last; ++sample) {
          const Rgb radiance = share.samples.trace(x, y, sample, share.visibility, share.log);
          pixel.add(finite(radiance, x, y, sample, share), replicate_size());
        }
        result_.film.at(x, y) = pixel;
      }
  }

  // Whole groups, one sample of each pixel. Tile (0,0) begins where the grid of groups does.
  void render_shared_tile(int tile, std::uint64_t sample, Share& share) {
    const PixelGroups groups = groups_of(options_, sample);
    const int interleaved = groups.groups_per_tile();
    const int n = tile_edge_ / groups.tile_edge();
    const int column = tile % tiles_x_ * n, row = tile / tiles_x_ * n;
    for (int i = 0; i < n * n * interleaved; ++i) {
      const int cell = i / interleaved;
      const PixelGroups::Place place{column + cell % n, row + cell / n, i % interleaved};
      share.cause_in_group.reset();
      share.groups.trace(groups, place, sample, {-1, -1}, share.visibility, share.log);
      const auto pixels = share.groups.pixels();
      for (std::size_t k = 0; k < pixels.size(); ++k) {
        const auto [x, y] = pixels[k];
        result_.film.at(x, y).add(finite(share.groups.radiance(k), x, y, sample, share),
                                  replicate_size());
      }
    }
  }

  Rgb finite(const Rgb& radiance, int x, int y, std::uint64_t sample, Share& share) {
    ++share.paths;
    if (is_finite(radiance)) return radiance;
    const NonFiniteCause cause =
        shared_ ? cause_in_group(x, y, sample, share) : non_finite_cause(share.log);
    ++share.non_finite[static_cast<std::size_t>(cause)];
    share.named.push_back({x, y, sample, cause});
    keep_first(share.named);
    return Rgb(0.0f);
  }

  // The log of a group is that of one of its pixels, so that the group is traced again. A path that
  // overflows reaches all that see it: of those, only the ones that will be named are traced again
  // each; the others are counted with the cause of the one before.
  NonFiniteCause cause_in_group(int x, int y, std::uint64_t sample, Share& share) {
    const bool named =
        share.named.size() < kNamedSamples || is_before({x, y, sample, {}}, share.named.back());
    if (named || !share.cause_in_group) {
      Visibility uncounted(scene_);
      trace_sample(scene_, camera_, options_, x, y, sample, uncounted, share.log);
      share.cause_in_group = non_finite_cause(share.log);
    }
    return *share.cause_in_group;
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
  const bool shared_;
  const int tile_edge_, tiles_x_, tiles_y_;
  const std::uint64_t samples_per_pass_, passes_;
  std::vector<std::atomic<std::uint64_t>> passes_done_;  // of each tile
  std::atomic<std::uint64_t> next_{0};
  std::atomic<std::uint64_t> done_{0};
  std::mutex mutex_;
};

}  // namespace

RenderResult render(const Scene& scene, const RenderOptions& options, const std::atomic<bool>& stop,
                    const ProgressCallback& progress) {
  RenderResult result(Film(options.width, options.height));
  const auto start = std::chrono::steady_clock::now();
  Job job(scene, options, stop, progress, result);
  result.threads = run_in_threads(options.threads, [&job] { job.work(); });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  result.render_seconds = wall.count();
  result.complete =
      result.paths == options.spp * static_cast<std::uint64_t>(options.width) * options.height;
  keep_first(result.first_non_finite);
  return result;
}

}  // namespace raytracing
