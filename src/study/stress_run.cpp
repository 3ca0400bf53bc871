#include "raytracing/study/stress_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>
#include <stdexcept>

#include "raytracing/integrator/shade.h"
#include "raytracing/render/threads.h"
#include "raytracing/scene/recenter.h"
#include "raytracing/study/power_law.h"
#include "stress_maker.h"

namespace raytracing {
namespace {

constexpr double kFamilyLevel = 0.01;   // probability of a false alarm in a run
constexpr double kRounding = 1e-4;      // relative: of the methods' arithmetic in float32
constexpr double kNoisy = 0.1;          // relative RMSE
constexpr double kLargestShare = 0.01;  // of one sample in the sum
// What is expected to be met so often by chance is missed with a probability of exp(-12).
constexpr double kFewestHits = 12;
constexpr double kDarkPixels = 0.01;
constexpr std::uint64_t kRepetitionFactor = 4;

// Central moments of the pixels' means; two passes keep the digits.
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
struct Subject {
  const StressScene& stress;
  const Scene& scene;
  int line_rays;
  const std::atomic<bool>& stop;
};

// The pixels of seeds first .. first + count - 1; those so far when stopped.
void measure(const Subject& subject, std::uint64_t first, std::uint64_t count, StressCell& cell) {
  const auto& [stress, scene, line_rays, stop] = subject;
  const ShadeOptions options{cell.method, stress.max_depth, line_rays};
  Visibility visibility(scene);
  PathLog log;
  std::vector<double> pixels;
  cell.not_finite = 0;
  cell.largest_sample = 0;
  double total = 0, dark = 0;
  const double start = thread_cpu_seconds();
  for (std::uint64_t seed = first; seed < first + count && !stop; ++seed)
    for (std::uint32_t x = 0; x < kPixelsPerSeed; ++x) {
      double sum = 0;
      for (std::uint64_t i = 0; i < kStressSpp; ++i) {
        PathSampler sampler(SamplerKind::sobol, seed, x, 0, i);
        const float value = shade(scene, options, stress.ray, sampler, visibility, log).x;
        if (!std::isfinite(value) || value < 0) {
          ++cell.not_finite;
          continue;
        }
        sum += static_cast<double>(value);
        cell.largest_sample = std::max(cell.largest_sample, static_cast<double>(value));
      }
      total += sum;
      dark += sum == 0;
      pixels.push_back(sum / kStressSpp);
    }
  cell.pixels = pixels.size();
  cell.nanoseconds =
      1e9 * (thread_cpu_seconds() - start) / static_cast<double>(kStressSpp * pixels.size());
  cell.largest_share = total > 0 ? cell.largest_sample / total : 0;
  cell.dark_pixels = dark / static_cast<double>(pixels.size());
  set_moments(pixels, cell);
}

bool looks_biased(const StressCell& cell, double critical_z) {
  return cell.resolved() && std::abs(cell.z()) > critical_z;
}

Verdict verdict(const StressCell& cell, double critical_z) {
  if (cell.not_finite > 0) return Verdict::broken;
  if (looks_biased(cell, critical_z)) return Verdict::biased;
  return cell.relative_rmse() > kNoisy ? Verdict::noisy : Verdict::holds;
}

std::vector<StressCell> measure_setting(const StressCase& c, const StressSetting& setting,
                                        const StressPlan& plan, double critical_z,
                                        const std::atomic<bool>& stop) {
  const StressScene made = setting.make();
  // As for any scene that is rendered.
  const StressScene stress = stress::transformed(made, 1, -find_recentering(made.scene).origin);
  const Scene scene(stress.scene, 1);
  const auto hit = scene.geometry().closest_hit(stress.ray);
  if (!hit) throw std::runtime_error(fmt::format("{} {}: no receiver", c.name, setting.label));
  const StressTruth truth = exact_radiance(stress, scene.vertex(stress.ray, *hit));
  const Subject subject{stress, scene, plan.line_rays, stop};
  std::vector<StressCell> cells;
  for (const DirectMethod* method : plan.methods) {
    StressCell cell{&c, &setting, method, truth};
    measure(subject, 1, plan.seeds, cell);
    if (looks_biased(cell, critical_z)) {
      measure(subject, 1 + plan.seeds, kRepetitionFactor * plan.seeds, cell);
      cell.repeated = true;
    }
    cell.verdict = verdict(cell, critical_z);
    cells.push_back(cell);
  }
  return cells;
}

double critical_z_of(const StressPlan& plan) {
  std::size_t tests = 0;
  for (const StressCase* c : plan.cases)
    for (const DirectMethod* method : plan.methods)
      tests += method->unbiased ? c->settings.size() : 0;
  return student_t_quantile(1 - kFamilyLevel / static_cast<double>(std::max<std::size_t>(tests, 1)),
                            static_cast<int>(plan.seeds * kPixelsPerSeed) - 1);
}

/// One setting to be measured, and what came of it.
struct Job {
  const StressCase* stress_case;
  const StressSetting* setting;
  std::vector<StressCell> cells;
};

// Of several threads; rethrows what one of them throws.
bool do_jobs(std::vector<Job>& jobs, const StressPlan& plan, double critical_z,
             const std::atomic<bool>& stop,
             const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;  // of all below
  std::uint64_t done = 0;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < jobs.size() && !stop; i = next++) {
        jobs[i].cells =
            measure_setting(*jobs[i].stress_case, *jobs[i].setting, plan, critical_z, stop);
        if (stop) return;  // perhaps in its midst
        const std::lock_guard lock(mutex);
        ++done;
        if (progress) progress(done, jobs.size());
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      next = jobs.size();
    }
  };
  run_in_threads(plan.threads, work);
  if (failure) std::rethrow_exception(failure);
  return done == jobs.size();
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::noisy:
      return "noisy";
    case Verdict::biased:
      return "biased";
    case Verdict::broken:
      break;
  }
  return "broken";
}

double StressCell::relative(double value) const {
  return truth.radiance > 0 ? value / truth.radiance : value;
}

double StressCell::z() const {
  const double allowed = truth.rounding + kRounding * truth.radiance;
  const double bias = mean - truth.radiance;
  const double beyond = std::copysign(std::max(0.0, std::abs(bias) - allowed), bias);
  if (beyond == 0) return 0;
  if (standard_error == 0) return std::copysign(INFINITY, beyond);
  const double t = beyond / standard_error;
  return t + skewness / (6 * std::sqrt(static_cast<double>(pixels))) * (1 + 2 * t * t);
}

bool StressCell::resolved() const {
  // A method may be of two kinds of pixels, one of which finds the visible part by chance alone.
  const double hits = 0.5 * truth.visible_share * static_cast<double>(kStressSpp * pixels);
  if (dark_pixels > kDarkPixels && hits < kFewestHits) return false;
  return largest_share < kLargestShare;
}

std::vector<const StressCell*> StressResult::failures() const {
  std::vector<const StressCell*> result;
  for (const StressCell& cell : cells)
    if (cell.verdict == Verdict::broken ||
        (cell.verdict == Verdict::biased && cell.method->unbiased))
      result.push_back(&cell);
  return result;
}

std::string stress_rule(double critical_z) {
  return fmt::format(
      "broken: a sample is not finite or below 0. biased: |z| > {:.2f} in two independent "
      "measurements, where z is the bias beyond rounding over its standard error, corrected for "
      "skewness. Rounding: {:g} of the truth, and what the truth changes when shadow rays begin "
      "off the surface, as they do, and occluders move by 4 float roundings. No bias is told where "
      "one sample holds {:g} % of the sum or more, or where pixels are dark and the visible part "
      "of the lights is too small for a uniform point to hit it {:g} times: the mean then hangs on "
      "what was not met yet. Unbiased methods are called biased in at most one of {:g} runs "
      "(Bonferroni). noisy: relative RMSE of {} samples above {:g}. holds: none of these.",
      critical_z, kRounding, 100 * kLargestShare, 2 * kFewestHits, 1 / kFamilyLevel, kStressSpp,
      kNoisy);
}

StressResult run_stress(const StressPlan& plan, const std::atomic<bool>& stop,
                        const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  StressResult result;
  result.critical_z = critical_z_of(plan);
  std::vector<Job> jobs;
  for (const StressCase* c : plan.cases)
    for (const StressSetting& setting : c->settings) jobs.push_back({c, &setting, {}});
  result.complete = do_jobs(jobs, plan, result.critical_z, stop, progress);
  if (!result.complete) return result;
  for (const Job& job : jobs)
    result.cells.insert(result.cells.end(), job.cells.begin(), job.cells.end());
  return result;
}

}  // namespace raytracing
