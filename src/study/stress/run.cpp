#include "raytracing/study/stress/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "case_builder.h"
#include "raytracing/integrator/path_tracer.h"
#include "raytracing/render/pixel_groups.h"
#include "raytracing/render/render.h"
#include "raytracing/render/threads.h"
#include "raytracing/scene/description.h"

namespace raytracing {
namespace {

constexpr std::uint64_t kRepetitionFactor = 4;
constexpr int kGroupPictures = 3;  // whose samples are taken as one measurement
constexpr int kGroupPixels = PixelGroups::kMaxEdge * PixelGroups::kMaxEdge;

// Sets the moments of the pixels' means; two passes avoid cancellation.
void set_moments(const std::vector<double>& pixels, StressCell& cell) {
  const auto n = static_cast<double>(pixels.size());
  double sum = 0, squares = 0;
  for (const double x : pixels) {
    sum += x;
    squares += (x - cell.truth.radiance) * (x - cell.truth.radiance);
  }
  cell.mean = sum / n;
  cell.rmse = std::sqrt(squares / n);
  double second = 0, third = 0;
  for (const double x : pixels) {
    const double d = x - cell.mean;
    second += d * d;
    third += d * d * d;
  }
  cell.standard_error = std::sqrt(second / (n * (n - 1)));
  const double deviation = std::sqrt(second / n);
  cell.skewness = deviation > 0 ? third / (n * deviation * deviation * deviation) : 0;
}

/// One setting, ready to be measured.
struct PreparedSetting {
  const StressScene& stress;
  const Scene& scene;
  int line_rays;
  const std::atomic<bool>& stop;
};

/// The samples of one pixel, or of pictures whose pixels share paths.
struct SampleSum {
  double sum = 0, largest = 0;
  std::uint64_t not_finite = 0;

  void add(double value) {
    if (std::isfinite(value) && value >= 0) {
      sum += value;
      largest = std::max(largest, value);
    } else {
      ++not_finite;
    }
  }
};

SampleSum sample_pixel(const PreparedSetting& prepared, const PathOptions& options,
                       RayQueries& rays, std::uint64_t seed, std::uint32_t x) {
  const auto tracer = make_path_tracer(prepared.scene, options, false);
  PathLog log;
  SampleSum result;
  for (std::uint64_t i = 0; i < kStressSpp; ++i) {
    PathSample sample{PathSampler(SamplerKind::sobol, seed, x, 0, i), prepared.stress.ray};
    tracer->trace(std::span(&sample, 1), rays, log, 0);
    result.add(sample.radiance.x);
  }
  return result;
}

// The samples of pictures of the size of a group, in the default mode of rendering. With one sample
// per pixel, each pixel's value is that of a sample.
SampleSum sample_groups(const PreparedSetting& prepared, const PathOptions& path,
                        std::uint64_t seed) {
  RenderOptions options;
  options.width = options.height = options.reuse = PixelGroups::kMaxEdge;
  options.spp = 1;
  options.path = path;
  SampleSum result;
  for (std::uint64_t i = 0; i < kGroupPictures; ++i) {
    options.seed = kGroupPictures * seed + i;
    const RenderResult picture = render(prepared.scene, options, prepared.stop, {});
    result.not_finite += picture.non_finite_samples;
    for (int y = 0; y < options.height; ++y)
      for (int x = 0; x < options.width; ++x) result.add(picture.film.at(x, y).mean().x);
  }
  return result;
}

// Measures the pixels of the seeds first .. first + count - 1, or fewer when stopped.
void measure(const PreparedSetting& prepared, std::uint64_t first, std::uint64_t count,
             StressCell& cell) {
  const PathOptions options{cell.method, prepared.stress.max_depth, prepared.line_rays};
  const bool shared = prepared.stress.shares_paths;
  cell.samples = shared ? kGroupPictures * kGroupPixels : kStressSpp;
  RayQueries rays(prepared.scene);
  std::vector<double> pixels;
  cell.not_finite = 0;
  cell.largest_sample = 0;
  double total = 0, dark = 0;
  const double start = thread_cpu_seconds();
  for (std::uint64_t seed = first; seed < first + count && !prepared.stop; ++seed)
    for (std::uint32_t x = 0; x < kPixelsPerSeed; ++x) {
      const SampleSum pixel = shared ? sample_groups(prepared, options, seed * kPixelsPerSeed + x)
                                     : sample_pixel(prepared, options, rays, seed, x);
      cell.not_finite += pixel.not_finite;
      cell.largest_sample = std::max(cell.largest_sample, pixel.largest);
      total += pixel.sum;
      dark += pixel.sum == 0;
      pixels.push_back(pixel.sum / cell.samples);
    }
  const auto count_of_pixels = static_cast<double>(pixels.size());
  cell.pixels = pixels.size();
  const double seconds = thread_cpu_seconds() - start;
  cell.nanoseconds = 1e9 * seconds / (cell.samples * count_of_pixels);
  cell.largest_share = total > 0 ? cell.largest_sample / total : 0;
  cell.dark_pixels = dark / count_of_pixels;
  set_moments(pixels, cell);
}

std::vector<StressCell> measure_setting(const StressCase& c, const StressSetting& setting,
                                        const StressPlan& plan, double critical_z,
                                        const std::atomic<bool>& stop) {
  const StressScene made = setting.make();
  // Every scene that is rendered is moved to the origin in this way.
  const StressScene stress = stress::transformed(made, 1, -find_recentering(made.scene).origin);
  const Scene scene(stress.scene, 1);
  const auto hit = scene.geometry().closest_hit(stress.ray);
  if (!hit) throw std::runtime_error(fmt::format("{} {}: no receiver", c.name, setting.label));
  const StressTruth truth = exact_radiance(stress, scene.vertex(stress.ray, *hit));
  const PreparedSetting prepared{stress, scene, plan.line_rays, stop};
  std::vector<StressCell> cells;
  for (const DirectMethod* method : plan.methods) {
    StressCell cell{&c, &setting, method, truth};
    measure(prepared, 1, plan.seeds, cell);
    if (looks_biased(cell, critical_z)) {
      measure(prepared, 1 + plan.seeds, kRepetitionFactor * plan.seeds, cell);
      cell.repeated = true;
    }
    cell.verdict = verdict_on(cell, critical_z);
    cells.push_back(cell);
  }
  return cells;
}

double critical_z_of(const StressPlan& plan) {
  std::size_t tests = 0;
  for (const StressCase* c : plan.cases)
    for (const DirectMethod* method : plan.methods)
      tests += method->unbiased ? c->settings.size() : 0;
  return critical_z(tests, plan.seeds * kPixelsPerSeed);
}

/// One setting to be measured, and its results.
struct SettingTask {
  const StressCase* stress_case;
  const StressSetting* setting;
  std::vector<StressCell> cells;
};

// Does the tasks in several threads. False when stopped.
bool do_tasks(std::vector<SettingTask>& tasks, const StressPlan& plan, double critical_z,
              const std::atomic<bool>& stop,
              const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;  // guards `done` and `progress`
  std::uint64_t done = 0;
  run_in_threads(plan.threads, [&] {
    for (std::size_t i = next++; i < tasks.size() && !stop; i = next++) {
      tasks[i].cells =
          measure_setting(*tasks[i].stress_case, *tasks[i].setting, plan, critical_z, stop);
      if (stop) return;  // the task may be incomplete
      const std::lock_guard lock(mutex);
      ++done;
      if (progress) progress(done, tasks.size());
    }
  });
  return done == tasks.size();
}

}  // namespace

StressResult run_stress(const StressPlan& plan, const std::atomic<bool>& stop,
                        const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  StressResult result;
  result.critical_z = critical_z_of(plan);
  std::vector<SettingTask> tasks;
  for (const StressCase* c : plan.cases)
    for (const StressSetting& setting : c->settings) tasks.push_back({c, &setting, {}});
  result.complete = do_tasks(tasks, plan, result.critical_z, stop, progress);
  if (!result.complete) return result;
  for (const SettingTask& task : tasks)
    result.cells.insert(result.cells.end(), task.cells.begin(), task.cells.end());
  return result;
}

}  // namespace raytracing
