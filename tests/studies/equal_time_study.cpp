// Error over time in the penumbrae of the Cornell box.

#include <array>
#include <atomic>
#include <functional>
#include <map>
#include <thread>

#include "raytracing/io/scene_file.h"
#include "raytracing/render/render.h"
#include "raytracing/study/metrics/statistics.h"
#include "raytracing/study/page/result_folder.h"
#include "studies/study.h"

namespace raytracing {
namespace {

constexpr int kSize = 256;    // of the picture
constexpr int kMaskStep = 3;  // every third pixel of the mask is measured
constexpr int kSeeds = 4;
constexpr int kThreads = 2;
constexpr int kTimings = 9;  // whole renders of each method
constexpr int kTimedSpp = 8;
constexpr std::uint64_t kReferenceSpp = 8192;  // of each half
constexpr double kTargets[] = {1e-5, 1e-6};

struct Pixel {
  int x, y;
};

struct Entry {
  std::string name;
  const char* method;
  int largest_log;      // of the samples per pixel
  bool padded = false;  // an experiment: the light's numbers from a pair of their own
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      {"point", "point", 12},
      {"solid-angle", "solid-angle", 12},
      {"line-rays", "line-rays", 10},
      {"line", "line", 9},
      {"solid-angle, padded", "solid-angle", 10, true},
      {"line, padded", "line", 9, true},
  };
  return all;
}

// Whether the pixel shows one flat surface, partly in the light.
bool is_penumbra(const Scene& scene, const Camera& camera, const Pixel& pixel) {
  RayQueries visibility(scene);
  const AreaLight& light = scene.lights()[0];
  std::optional<Vertex> first;
  for (int k = 0; k < 25; ++k) {
    const Ray ray = camera.ray(static_cast<float>(pixel.x) + static_cast<float>(k % 5) / 4,
                               static_cast<float>(pixel.y) + static_cast<float>(k / 5) / 4);
    const std::optional<Hit> hit = visibility.closest_hit(ray);
    if (!hit) return false;
    const Vertex v = scene.vertex(ray, *hit);
    if (v.light != kNone) return false;
    if (!first) first = v;
    if (dot(first->ng, v.ng) < 0.9999f ||
        std::abs(dot(first->ng, v.position - first->position)) > 1)
      return false;
  }
  constexpr int kSide = 12;
  int seen = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const Vec2 u{(static_cast<float>(i % kSide) + 0.5f) / kSide,
                 (static_cast<float>(i / kSide) + 0.5f) / kSide};
    const Vec3 q = sample_area(light, u);
    seen += dot(q - first->position, first->ng) > 0 && !visibility.occluded(*first, q, light);
  }
  return seen > 1 && seen < kSide * kSide - 1;
}

// One sample: what render() takes for direct light alone.
DVec3 take_sample(const Scene& scene, const Camera& camera, const Entry& entry, const Pixel& pixel,
                  std::uint64_t seed, std::uint64_t index, RayQueries& visibility) {
  const DirectMethod& method = direct_method(entry.method);
  PathSampler sampler(SamplerKind::sobol, seed, static_cast<std::uint32_t>(pixel.x),
                      static_cast<std::uint32_t>(pixel.y), index);
  const std::uint32_t light_pair = entry.padded ? 4 : 1;
  const Vec2 jitter = sampler.pair(0);
  const Ray ray =
      camera.ray(static_cast<float>(pixel.x) + jitter.x, static_cast<float>(pixel.y) + jitter.y);
  const std::optional<Hit> hit = visibility.closest_hit(ray);
  if (!hit) return DVec3(0.0);
  const Vertex v = scene.vertex(ray, *hit);
  const DirectQuery query{v,       scene.lights()[0], 1.0f, sampler.pair(light_pair),
                          sampler, light_pair,        4};
  return DVec3(estimate_direct(method, query, visibility));
}

// Calls work(pixel number) for all pixels, on all threads.
void for_pixels(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> threads;
  for (int i = 0; i < kThreads; ++i)
    threads.emplace_back([&] {
      for (std::size_t p = next++; p < count; p = next++) work(p);
    });
}

struct Reference {
  std::vector<DVec3> mean;
  double floor = 0;  // relMSE of the mean
};

double relative_square(const DVec3& difference, const DVec3& mean) {
  const DVec3 square = difference * difference / (mean * mean + 0.01);
  return (square.x + square.y + square.z) / 3;
}

Reference make_reference(const Scene& scene, const Camera& camera,
                         const std::vector<Pixel>& pixels) {
  const Entry line{"", "line", 0};
  std::vector<DVec3> halves[2];
  for (const std::uint64_t half : {0, 1}) {
    halves[half].resize(pixels.size());
    for_pixels(pixels.size(), [&](std::size_t p) {
      RayQueries visibility(scene);
      DVec3 sum(0.0);
      for (std::uint64_t i = 0; i < kReferenceSpp; ++i)
        sum += take_sample(scene, camera, line, pixels[p], 1001 + half, i, visibility);
      halves[half][p] = sum / static_cast<double>(kReferenceSpp);
    });
  }
  Reference reference;
  for (std::size_t p = 0; p < pixels.size(); ++p) {
    reference.mean.push_back(0.5 * (halves[0][p] + halves[1][p]));
    reference.floor += relative_square(0.5 * (halves[0][p] - halves[1][p]), reference.mean[p]) /
                       static_cast<double>(pixels.size());
  }
  return reference;
}

// relMSE after 1, 2, 4, ... samples per pixel, the reference's own subtracted.
std::vector<double> measure_errors(const Scene& scene, const Camera& camera, const Entry& entry,
                                   const std::vector<Pixel>& pixels, const Reference& reference) {
  const int logs = entry.largest_log + 1;
  std::vector<std::vector<double>> errors(pixels.size(), std::vector<double>(logs));
  for_pixels(pixels.size(), [&](std::size_t p) {
    RayQueries visibility(scene);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      DVec3 sum(0.0);
      int log = 0;
      for (std::uint64_t i = 1; i <= std::uint64_t{1} << entry.largest_log; ++i) {
        sum += take_sample(scene, camera, entry, pixels[p], seed, i - 1, visibility);
        if (i != std::uint64_t{1} << log) continue;
        errors[p][log++] +=
            relative_square(sum / static_cast<double>(i) - reference.mean[p], reference.mean[p]) /
            kSeeds;
      }
    }
  });
  std::vector<double> mean(logs, -reference.floor);
  for (const auto& of_pixel : errors)
    for (int log = 0; log < logs; ++log)
      mean[log] += of_pixel[log] / static_cast<double>(pixels.size());
  return mean;
}

// Seconds of all threads for one sample per pixel of a whole picture; methods take turns.
std::map<std::string, double> measure_times(const Scene& scene) {
  std::map<std::string, std::vector<double>> seconds;
  for (int i = 0; i < kTimings; ++i)
    for (const char* method : {"point", "solid-angle", "line-rays", "line"}) {
      RenderOptions options;
      options.width = options.height = kSize;
      options.spp = kTimedSpp;
      options.path.method = &direct_method(method);
      options.path.max_depth = 1;
      options.threads = kThreads;
      const std::atomic<bool> stop{false};
      seconds[method].push_back(render(scene, options, stop, {}).cpu_seconds / kTimedSpp);
    }
  std::map<std::string, double> result;
  for (const auto& [method, values] : seconds) result[method] = median(values);
  return result;
}

struct Curve {
  std::vector<double> seconds, errors;
  PowerLaw law;  // of the error over the time, from 16 spp on

  // Time to an error: between neighbours, or by the law beyond the last, which `beyond` then tells.
  double time_to(double target, bool& beyond) const {
    beyond = errors.back() > target;
    if (beyond) return seconds.back() * std::pow(target / errors.back(), 1 / law.slope);
    std::size_t i = 1;
    while (i + 1 < errors.size() && errors[i] > target) ++i;
    const double slope =
        std::log(errors[i] / errors[i - 1]) / std::log(seconds[i] / seconds[i - 1]);
    return seconds[i] * std::pow(target / errors[i], 1 / slope);
  }
};

Curve make_curve(const std::vector<double>& errors, double seconds_per_spp) {
  Curve curve;
  for (std::size_t log = 2; log < errors.size(); ++log) {
    if (errors[log] <= 0) break;
    curve.seconds.push_back(seconds_per_spp * static_cast<double>(1 << log));
    curve.errors.push_back(errors[log]);
  }
  curve.law =
      *fit_power_law(std::span(curve.seconds).subspan(2), std::span(curve.errors).subspan(2));
  return curve;
}

// The curves' colours and marks, those of their methods, for the chart.
std::string chart_style() {
  std::vector<std::string> colours, marks;
  int plain = 0;
  for (const Entry& entry : entries()) {
    const DirectMethod& method = direct_method(entry.method);
    colours.emplace_back(method.colour);
    marks.push_back(std::to_string(method.mark));
    plain += !entry.padded;
  }
  return gnuplot_array("colour", colours) + gnuplot_array("mark", marks) +
         fmt::format("plain = {}\n", plain);
}

void run(StudyReport& report) {
  LoadReport notes;
  SceneFile file = load_scene_file(std::string(RAYTRACING_SOURCE_DIR) + "/scenes/cornell.toml",
                                   direct_method_names(), notes);
  const Scene scene(std::move(file.scene), kThreads);
  const Camera camera(scene.camera(), kSize, kSize);
  std::vector<Pixel> pixels;
  int in_mask = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      if (is_penumbra(scene, camera, {x, y}) && in_mask++ % kMaskStep == 0)
        pixels.push_back({x, y});
  const std::map<std::string, double> seconds = measure_times(scene);
  const Reference reference = make_reference(scene, camera, pixels);
  report.print(
      "# Equal time in penumbrae\n\n"
      "cornell at {0} x {0}, direct light only, sampler sobol. relMSE over {1} of the {2} "
      "penumbra pixels that show one flat surface, {3} seeds each. Reference: two halves of "
      "line at {4} spp; its own relMSE, {5:.1e}, is subtracted. Time: processor time of all "
      "threads for the whole picture; median of {6} renders of {7} spp, the methods in turn, "
      "times the samples. \"Padded\" is an experiment that render() does not offer: pixel and "
      "light by separate 2D pairs, at the time of the method.\n\n",
      kSize, pixels.size(), in_mask, kSeeds, kReferenceSpp, reference.floor, kTimings, kTimedSpp);
  report.print(
      "| method | time of one spp / point's | relMSE at 16 | 64 | 256 | last | exponent | "
      "s to 1e-5 | s to 1e-6 |\n|---|---|---|---|---|---|---|---|---|\n");
  std::string csv;
  std::map<std::string, std::array<double, 2>> times;
  for (const Entry& entry : entries()) {
    const std::vector<double> errors = measure_errors(scene, camera, entry, pixels, reference);
    const double cost = seconds.at(entry.method);
    const Curve curve = make_curve(errors, cost);
    report.print("| {} | {:.2f} | {:.2e} | {:.2e} | {:.2e} | {:.2e} at {} | {:.2f} ± {:.2f} |",
                 entry.name, cost / seconds.at("point"), errors[4], errors[6], errors[8],
                 errors.back(), 1 << entry.largest_log, curve.law.slope, curve.law.slope_error);
    for (std::size_t t = 0; t < std::size(kTargets); ++t) {
      bool beyond = false;
      times[entry.name][t] = curve.time_to(kTargets[t], beyond);
      report.print(" {:.3g}{} |", times[entry.name][t], beyond ? " (extrapolated)" : "");
    }
    report.print("\n");
    csv += entry.name + ";\n";
    for (std::size_t i = 0; i < curve.seconds.size(); ++i)
      csv += fmt::format("{:.5g};{:.4e}\n", curve.seconds[i], curve.errors[i]);
    csv += "\n\n";
  }
  report.print("\n");
  for (std::size_t t = 0; t < std::size(kTargets); ++t) {
    const double best =
        std::min({times["point"][t], times["solid-angle"][t], times["line-rays"][t]});
    report.print("To relMSE {:.0e} the best method of points takes {:.1f} times line's time.\n",
                 kTargets[t], best / times["line"][t]);
  }
  report.write_csv("curves", csv);
  report.write_style(chart_style());
  report.write_text();
}

}  // namespace
}  // namespace raytracing

int main(int argc, char** argv) {
  raytracing::StudyReport report(argc, argv, "equal_time");
  raytracing::run(report);
}
