#include "raytracing/render/render.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "group_tracer.h"
#include "raytracing/render/threads.h"

namespace raytracing {
namespace {

constexpr std::size_t kMaxNamedSamples = 8;
// The picture is refined in passes, so that one that is stopped early is noisy rather than torn. A
// pass is short where groups are shifted from sample to sample, longer where the samples of one
// pixel may follow each other.
constexpr std::uint64_t kSamplesPerPassOfPixels = 16;

bool is_before(const NonFiniteSample& a, const NonFiniteSample& b) {
  return std::tie(a.index.y, a.index.x, a.index.sample) <
         std::tie(b.index.y, b.index.x, b.index.sample);
}

// Keeps the few that come first in the picture, whatever thread found them.
void keep_first(std::vector<NonFiniteSample>& named) {
  std::sort(named.begin(), named.end(), is_before);
  if (named.size() > kMaxNamedSamples) named.resize(kMaxNamedSamples);
}

NonFiniteCause cause_of(const Scene& scene, const RenderOptions& options,
                        const SampleIndex& index) {
  return non_finite_cause(trace_sample(scene, options, index).log);
}

// How the picture is cut into tiles, each of whole groups of pixels.
struct TileGrid {
  int groups;         // tiles of groups along the edge of a tile
  int columns, rows;  // tiles of the picture
  bool shifted;       // whether tiles of successive samples overlap with their neighbours

  explicit TileGrid(const RenderOptions& options) {
    const int edge = PixelGroups::tile_edge(group_edge(options));
    groups = (options.tile_size + edge - 1) / edge;
    shifted = edge > 1;
    // A shift of up to edge - 1 pixels may take one more tile.
    const auto count = [&](int pixels) {
      return (pixels + edge - 1 + groups * edge - 1) / (groups * edge);
    };
    columns = count(options.width);
    rows = count(options.height);
  }
};

// The work of all threads: tile after tile of pass after pass, handed out by a counter.
class RenderJob {
 public:
  RenderJob(const Scene& scene, const RenderOptions& options, const std::atomic<bool>& stop,
            const ProgressCallback& progress, RenderResult& result)
      : scene_(scene),
        options_(options),
        camera_(scene.camera(), options.width, options.height),
        stop_(stop),
        progress_(progress),
        result_(result),
        grid_(options),
        samples_per_pass_(grid_.shifted ? 1 : kSamplesPerPassOfPixels),
        passes_((options.spp + samples_per_pass_ - 1) / samples_per_pass_),
        replicate_size_(options.replicates > 1 ? options.spp / options.replicates : 1),
        passes_done_(static_cast<std::size_t>(grid_.columns) * grid_.rows) {}

  // Runs in each thread.
  void work() {
    const double start = thread_cpu_seconds();
    Worker worker(scene_, camera_, options_, result_.layers.sums_samples());
    const std::uint64_t tiles = passes_done_.size();
    while (!stop_ && !failed_) {
      const std::uint64_t ticket = next_++;
      if (ticket >= tiles * passes_) break;
      const std::uint64_t tile = ticket % tiles, pass = ticket / tiles;
      // The samples of a pixel are added in order: another thread may still be at the last pass. It
      // always ends it, since `stop_` is looked at only before taking a ticket.
      wait_for_pass(static_cast<int>(tile), pass);
      finish_tile(static_cast<int>(tile), pass, worker);
    }
    add_to_result(worker, thread_cpu_seconds() - start);
  }

 private:
  // What one thread has done.
  struct Worker {
    Worker(const Scene& scene, const Camera& camera, const RenderOptions& options,
           bool keeps_first_hits)
        : tracer(scene, camera, options, keeps_first_hits) {}
    GroupTracer tracer;
    std::vector<PixelGroups> groups;  // of the samples of a pass
    std::uint64_t paths = 0;
    std::uint64_t reported = 0;
    std::array<std::uint64_t, kNonFiniteCauses> non_finite{};  // by cause
    std::vector<NonFiniteSample> named;
  };

  // Waits until the passes before this one are done wherever the tile adds samples.
  void wait_for_pass(int tile, std::uint64_t pass) {
    const int reach = grid_.shifted ? 1 : 0;
    const int column = tile % grid_.columns, row = tile / grid_.columns;
    for (int y = std::max(row - reach, 0); y <= std::min(row + reach, grid_.rows - 1); ++y)
      for (int x = std::max(column - reach, 0); x <= std::min(column + reach, grid_.columns - 1);
           ++x) {
        std::atomic<std::uint64_t>& done = passes_done_[y * grid_.columns + x];
        for (std::uint64_t n = done; n < pass; n = done) done.wait(n);
      }
  }

  // Renders the tile. Where that fails, other threads must not wait for it for ever.
  void finish_tile(int tile, std::uint64_t pass, Worker& worker) {
    try {
      render_tile(tile, pass, worker);
      report(worker);
    } catch (...) {
      failed_ = true;
      mark_done(tile);
      throw;
    }
    mark_done(tile);
  }

  void mark_done(int tile) {
    ++passes_done_[tile];
    passes_done_[tile].notify_all();
  }

  // All groups of the tile, all samples of the pass.
  void render_tile(int tile, std::uint64_t pass, Worker& worker) {
    const std::uint64_t first = pass * samples_per_pass_;
    const std::uint64_t last = std::min(first + samples_per_pass_, options_.spp);
    worker.groups.clear();
    for (std::uint64_t sample = first; sample < last; ++sample)
      worker.groups.push_back(groups_of(options_, sample));
    const int n = grid_.groups, interleaved = worker.groups[0].groups_per_tile();
    const int column = tile % grid_.columns * n, row = tile / grid_.columns * n;
    for (int i = 0; i < n * n * interleaved; ++i) {
      const int cell = i / interleaved;
      const PixelGroups::Place place{column + cell % n, row + cell / n, i % interleaved};
      for (std::uint64_t sample = first; sample < last; ++sample)
        render_group(worker.groups[sample - first], place, sample, worker);
    }
  }

  void render_group(const PixelGroups& groups, const PixelGroups::Place& place,
                    std::uint64_t sample, Worker& worker) {
    worker.tracer.trace(groups, place, sample);
    const auto pixels = worker.tracer.pixels();
    worker.paths += pixels.size();
    std::optional<NonFiniteCause> cause;  // of the group's first non-finite sample
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const auto [x, y] = pixels[k];
      const bool finite = is_finite(worker.tracer.radiance(k));
      if (!finite) count_non_finite({x, y, sample}, cause, worker);
      const Rgb radiance = finite ? worker.tracer.radiance(k) : Rgb(0.0f);
      Film::Pixel& pixel = result_.film.at(x, y);
      pixel.add(radiance, replicate_size_);
      if (!result_.layers.sums_samples()) continue;
      const Rgb direct = finite ? worker.tracer.direct(k) : Rgb(0.0f);
      result_.layers.add(x, y, pixel, {radiance, direct, worker.tracer.first_hit(k)});
    }
  }

  // The log of a group is that of one of its pixels, so that the cause is found by tracing the
  // sample again. A path that overflows reaches all pixels that see it: only the first of the group
  // is traced again.
  void count_non_finite(const SampleIndex& index, std::optional<NonFiniteCause>& cause,
                        Worker& worker) {
    if (!cause) cause = cause_of(scene_, options_, index);
    ++worker.non_finite[static_cast<std::size_t>(*cause)];
    worker.named.push_back({index, *cause});
    keep_first(worker.named);
  }

  void report(Worker& worker) {
    done_ += worker.paths - worker.reported;
    worker.reported = worker.paths;
    if (!progress_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return;
    progress_(done_, options_.spp * options_.width * options_.height);
  }

  void add_to_result(const Worker& worker, double cpu_seconds) {
    std::scoped_lock lock(mutex_);
    result_.rays += worker.tracer.rays().counts();
    result_.paths += worker.paths;
    for (std::size_t i = 0; i < kNonFiniteCauses; ++i) {
      result_.non_finite_samples += worker.non_finite[i];
      result_.non_finite_by_cause[i] += worker.non_finite[i];
    }
    result_.first_non_finite.insert(result_.first_non_finite.end(), worker.named.begin(),
                                    worker.named.end());
    result_.cpu_seconds += cpu_seconds;
  }

  const Scene& scene_;
  const RenderOptions& options_;
  const Camera camera_;
  const std::atomic<bool>& stop_;
  const ProgressCallback& progress_;
  RenderResult& result_;
  const TileGrid grid_;
  const std::uint64_t samples_per_pass_, passes_, replicate_size_;
  std::vector<std::atomic<std::uint64_t>> passes_done_;  // of each tile
  std::atomic<std::uint64_t> next_{0};
  std::atomic<std::uint64_t> done_{0};
  std::atomic<bool> failed_{false};  // a thread has thrown
  std::mutex mutex_;
};

}  // namespace

RenderResult render(const Scene& scene, const RenderOptions& options, const std::atomic<bool>& stop,
                    const ProgressCallback& progress) {
  if (!options.path.method) throw std::invalid_argument("render: no method of direct light");
  if (options.tile_size < 1) throw std::invalid_argument("render: the tile size must be positive");
  RenderResult result(Film(options.width, options.height));
  result.layers = LayerFilm(options.layers, options.width, options.height);
  const auto start = std::chrono::steady_clock::now();
  RenderJob job(scene, options, stop, progress, result);
  result.threads = run_in_threads(options.threads, [&job] { job.work(); });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  result.render_seconds = wall.count();
  result.complete =
      result.paths == options.spp * static_cast<std::uint64_t>(options.width) * options.height;
  keep_first(result.first_non_finite);
  for (NonFiniteSample& sample : result.first_non_finite)
    sample.cause = cause_of(scene, options, sample.index);
  return result;
}

}  // namespace raytracing
