// What shared paths cost and bring: error over time with groups of every edge, on every scene or on
// those that are named after the folder of the results.

#include <array>
#include <atomic>
#include <iterator>

#include "raytracing/io/film_image.h"
#include "raytracing/io/scene_file.h"
#include "raytracing/render/render.h"
#include "raytracing/study/metrics/flip.h"
#include "studies/study.h"

namespace raytracing {
namespace {

constexpr int kSize = 128;   // of the pictures
constexpr int kRegion = 16;  // edge, in pixels
constexpr int kThreads = 2;
constexpr int kEdges[] = {1, 2, 4, 8, 16};  // the first is without sharing
constexpr std::size_t kEdgeCount = std::size(kEdges);
constexpr struct {
  std::uint64_t spp;
  int seeds;
} kSteps[] = {{4, 8}, {16, 4}, {64, 2}, {256, 1}};
constexpr std::size_t kStepCount = std::size(kSteps);
constexpr std::size_t kFlipStep = 1;  // pictures of so few samples are looked at
constexpr std::size_t kFlipEdge = 4;

using Picture = std::vector<DVec3>;

struct Render {
  Picture picture;
  double seconds;  // of all threads
};

Render render_once(const Scene& scene, int edge, std::uint64_t spp, std::uint64_t seed) {
  RenderOptions options;
  options.width = options.height = kSize;
  options.spp = spp;
  options.reuse = edge;
  options.seed = seed;
  options.path.method = &direct_method("point");
  options.threads = kThreads;
  const std::atomic<bool> stop{false};
  const RenderResult result = render(scene, options, stop, {});
  Render once{{}, result.cpu_seconds};
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) once.picture.push_back(result.film.at(x, y).mean());
  return once;
}

// Two pictures of the same expectation as those that are measured, independent of them.
struct Truth {
  const Picture &a, &b;

  DVec3 mean(std::size_t pixel) const { return 0.5 * (a[pixel] + b[pixel]); }
  // The product with two errors has the expectation of the squared error: the pictures' own noise
  // does not enter, while a bias would.
  double relmse(const Picture& x) const {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const DVec3 r = mean(i);
      const DVec3 square = (x[i] - a[i]) * (x[i] - b[i]) / (r * r + 0.01);
      sum += (square.x + square.y + square.z) / 3;
    }
    return sum / static_cast<double>(x.size());
  }
  // Sums, weighted as in relMSE, over regions: how many times more their squared errors are than
  // they would be with the same errors, independent of each other.
  double region_excess(const Picture& x) const {
    double together = 0, apart = 0;
    for (int top = 0; top < kSize; top += kRegion)
      for (int left = 0; left < kSize; left += kRegion) {
        DVec3 sum_a(0.0), sum_b(0.0);
        for (int i = 0; i < kRegion * kRegion; ++i) {
          const std::size_t p = (top + i / kRegion) * kSize + left + i % kRegion;
          const DVec3 r = mean(p), scale = 1.0 / glm::sqrt(r * r + 0.01);
          const DVec3 ea = (x[p] - a[p]) * scale, eb = (x[p] - b[p]) * scale;
          sum_a += ea;
          sum_b += eb;
          apart += dot(ea, eb);
        }
        together += dot(sum_a, sum_b);
      }
    return together / apart;
  }
};

ImageData to_image(const Picture& picture) {
  ImageData image;
  image.width = image.height = kSize;
  image.channels = {"R", "G", "B"};
  for (const DVec3& c : picture)
    for (int i = 0; i < 3; ++i) image.values.push_back(static_cast<float>(c[i]));
  return image;
}

ImageData to_image(const Truth& truth) {
  Picture mean;
  for (std::size_t i = 0; i < truth.a.size(); ++i) mean.push_back(truth.mean(i));
  return to_image(mean);
}

struct Cell {
  double relmse = 0, seconds = 0;  // means over the seeds
  double efficiency() const { return 1 / (relmse * seconds); }
};

struct SceneResult {
  std::array<std::array<Cell, kEdgeCount>, kStepCount> cells;
  std::uint64_t equal_spp = 0;  // without sharing, in the time of the sharing kFlipEdge
  double flip_off = 0, flip_on = 0;
  std::array<double, kEdgeCount> region_excess{};
};

std::uint64_t seed_of(std::size_t step, std::size_t edge, int i) {
  return 1000 * step + 100 * edge + static_cast<std::uint64_t>(i);
}

SceneResult measure(const Scene& scene) {
  SceneResult result;
  // The pictures of the most samples are the truth for the others and for each other.
  constexpr std::size_t last = kStepCount - 1;
  std::array<Render, kEdgeCount> finest;
  for (std::size_t e = 0; e < kEdgeCount; ++e)
    finest[e] = render_once(scene, kEdges[e], kSteps[last].spp, seed_of(last, e, 0));
  const auto truth_without = [&](std::size_t e) {
    return Truth{finest[e == 4 ? 2 : 4].picture, finest[e == 3 ? 2 : 3].picture};
  };
  for (std::size_t e = 0; e < kEdgeCount; ++e)
    result.cells[last][e] = {truth_without(e).relmse(finest[e].picture), finest[e].seconds};
  const Truth truth = truth_without(0);
  const ImageData truth_image = to_image(truth);
  for (std::size_t step = 0; step < last; ++step)
    for (int i = 0; i < kSteps[step].seeds; ++i)
      for (std::size_t e = 0; e < kEdgeCount; ++e) {
        const Render r = render_once(scene, kEdges[e], kSteps[step].spp, seed_of(step, e, i));
        Cell& cell = result.cells[step][e];
        cell.relmse += truth.relmse(r.picture) / kSteps[step].seeds;
        cell.seconds += r.seconds / kSteps[step].seeds;
        if (step != kFlipStep) continue;
        result.region_excess[e] += truth.region_excess(r.picture) / kSteps[step].seeds;
        if (e == kFlipEdge)
          result.flip_on +=
              masked_mean(flip_map(to_image(r.picture), truth_image)) / kSteps[step].seeds;
      }
  const auto& row = result.cells[kFlipStep];
  result.equal_spp = static_cast<std::uint64_t>(std::ceil(
      static_cast<double>(kSteps[kFlipStep].spp) * row[kFlipEdge].seconds / row[0].seconds));
  for (int i = 0; i < kSteps[kFlipStep].seeds; ++i) {
    const Render r = render_once(scene, 1, result.equal_spp, seed_of(kStepCount, 0, i));
    result.flip_off +=
        masked_mean(flip_map(to_image(r.picture), truth_image)) / kSteps[kFlipStep].seeds;
  }
  return result;
}

void print_rows(StudyReport& report, const std::string& name, const SceneResult& result) {
  for (std::size_t step = 0; step < kStepCount; ++step) {
    const auto& row = result.cells[step];
    report.print("| {} | {} | {:.3g} s, {:.2e} |", name, kSteps[step].spp, row[0].seconds,
                 row[0].relmse);
    for (std::size_t e = 1; e < kEdgeCount; ++e)
      report.print(" {:.2f}, {:.1f}, **{:.1f}** |", row[e].seconds / row[0].seconds,
                   row[0].relmse / row[e].relmse, row[e].efficiency() / row[0].efficiency());
    report.print("\n");
  }
}

std::string flip_row(const std::string& name, const SceneResult& result) {
  return fmt::format("| {} | {} | {:.4f} | {:.4f} |\n", name, result.equal_spp, result.flip_off,
                     result.flip_on);
}

std::string region_row(const std::string& name, const SceneResult& result) {
  const auto& excess = result.region_excess;
  return fmt::format("| {} | {:.2f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n", name, excess[0],
                     excess[1], excess[2], excess[3], excess[4]);
}

// One block per edge, one column per scene.
std::string to_csv(const std::vector<std::string>& names, const std::vector<SceneResult>& results) {
  std::string csv;
  for (std::size_t e = 1; e < kEdgeCount; ++e) {
    csv += "spp";
    for (const std::string& name : names) csv += ";" + name;
    csv += "\n";
    for (std::size_t step = 0; step < kStepCount; ++step) {
      csv += std::to_string(kSteps[step].spp);
      for (const SceneResult& r : results)
        csv +=
            fmt::format(";{:.3f}", r.cells[step][e].efficiency() / r.cells[step][0].efficiency());
      csv += "\n";
    }
    csv += "\n\n";
  }
  return csv;
}

std::vector<std::filesystem::path> scene_files(const std::vector<std::string>& wanted) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(RAYTRACING_SOURCE_DIR) + "/scenes"))
    if (entry.path().extension() == ".toml" &&
        (wanted.empty() ||
         std::find(wanted.begin(), wanted.end(), entry.path().stem()) != wanted.end()))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void run(StudyReport& report, const std::vector<std::string>& wanted) {
  report.print(
      "# Shared paths\n\n"
      "Every scene at {0} x {0}, all bounces, light sampling `point`, `--reuse` 1 by turns with 2, "
      "4, 8 and 16. Without sharing: processor seconds of all threads, and relMSE. With it: time, "
      "**relative to without**; error, how many times less; **efficiency 1/(relMSE s), how many "
      "times more**. Means over {1}, {2}, {3} and {4} seeds at {5}, {6}, {7} and {8} spp. The "
      "truth is that of two pictures of {8} spp with sharing and other seeds, by products of the "
      "differences to the one and to the other: their own noise does not enter.\n\n",
      kSize, kSteps[0].seeds, kSteps[1].seeds, kSteps[2].seeds, kSteps[3].seeds, kSteps[0].spp,
      kSteps[1].spp, kSteps[2].spp, kSteps[3].spp);
  report.print(
      "| scene | spp | off | 2 x 2: time, error, efficiency | 4 x 4 | 8 x 8 | 16 x 16 |\n"
      "|---|---|---|---|---|---|---|\n");
  std::vector<std::string> names;
  std::vector<SceneResult> results;
  std::string flip_rows, region_rows;
  for (const std::filesystem::path& file : scene_files(wanted)) {
    LoadReport notes;
    const Scene scene(load_scene_file(file.string(), direct_method_names(), notes).scene, kThreads);
    names.push_back(file.stem().string());
    results.push_back(measure(scene));
    print_rows(report, names.back(), results.back());
    flip_rows += flip_row(names.back(), results.back());
    region_rows += region_row(names.back(), results.back());
  }
  report.print(
      "\n## How the pictures look\n\nMean FLIP (0 = equal, {} pixels per degree) at equal "
      "time: `--reuse {}` at {} spp against so many samples without sharing as take as "
      "long.\n\n| scene | spp without | FLIP without | FLIP with |\n|---|---|---|---|\n{}",
      kFlipPixelsPerDegree, kEdges[kFlipEdge], kSteps[kFlipStep].spp, flip_rows);
  report.print(
      "\n## How alike the errors of neighbours are\n\nVariance of means over regions of "
      "{0} x {0} pixels at {1} spp: how many times that of as many independent pixels "
      "with the same variances.\n\n| scene | off | 2 x 2 | 4 x 4 | 8 x 8 | 16 x 16 |\n"
      "|---|---|---|---|---|---|\n{2}",
      kRegion, kSteps[kFlipStep].spp, region_rows);
  report.write_csv("efficiency", to_csv(names, results));
  report.write_text();
}

}  // namespace
}  // namespace raytracing

int main(int argc, char** argv) {
  raytracing::StudyReport report(argc, argv, "reuse");
  raytracing::run(report, {argv + std::min(argc, 2), argv + argc});
}
