#include "raytracing/study/chart/runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <limits>

#include "raytracing/io/file.h"

namespace raytracing {
namespace {

constexpr std::uint64_t kFirstChunk = 16;  // samples per pixel

ImageData to_picture(int width, int height, const std::vector<DVec3>& values) {
  ImageData image;
  image.width = width;
  image.height = height;
  image.channels = {"R", "G", "B"};
  image.values.reserve(3 * values.size());
  for (const DVec3& v : values)
    for (const double c : {v.x, v.y, v.z}) image.values.push_back(static_cast<float>(c));
  return image;
}

std::vector<DVec3> means(const Film& film) {
  std::vector<DVec3> values;
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) values.push_back(film.at(x, y).mean());
  return values;
}

// The sums of all chunks of one half of the reference.
struct Half {
  std::vector<DVec3> sums;
  std::uint64_t spp = 0;

  void add(const Film& film, std::uint64_t chunk) {
    const std::vector<DVec3> chunk_means = means(film);
    sums.resize(chunk_means.size(), DVec3(0.0));
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] += chunk_means[i] * static_cast<double>(chunk);
    spp += chunk;
  }
  std::vector<DVec3> mean() const {
    std::vector<DVec3> result = sums;
    for (DVec3& v : result) v /= static_cast<double>(spp);
    return result;
  }
};

RunFacts facts_after(const ChartSettings& settings, const PlannedRun& run,
                     const RenderResult& result) {
  RunFacts facts = planned_facts(settings, run);
  add_result(facts, run_options(settings, run), result);
  facts.variance_kind.reset();  // the pictures have no variance layers
  facts.pixel_correlation.reset();
  return facts;
}

ChartRun measured(const RunFacts& facts, std::uint64_t repetition, const ImageData& picture,
                  const GroundTruth& truth) {
  const ErrorMetrics metrics = error_metrics(picture, truth.reference.picture, truth.counted);
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const auto& floor = truth.floor;
  ChartRun run;
  run.facts = facts;
  run.repetition = repetition;
  run.mse = metrics.mse;
  run.mse_corrected = floor ? metrics.mse - floor->mse.value : kUnknown;
  run.relmse = metrics.relmse;
  run.relmse_corrected = floor ? metrics.relmse - floor->relmse.value : kUnknown;
  run.smape = metrics.smape;
  run.largest = *std::max_element(picture.values.begin(), picture.values.end());
  return run;
}

}  // namespace

const DirectMethod& reference_method(const std::optional<std::uint32_t>& max_depth) {
  return direct_method(max_depth == 1u ? "line" : "point");
}

std::optional<ImageData> render_reference(const Scene& scene, const ChartSettings& settings,
                                          double seconds, const std::atomic<bool>& stop,
                                          const ProgressCallback& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  // Progress is in milliseconds, and not beyond the total when a chunk takes longer than planned.
  const auto report = [&](std::uint64_t, std::uint64_t) {
    const auto total = static_cast<std::uint64_t>(1000 * seconds) + 1;
    if (progress) progress(std::min(static_cast<std::uint64_t>(1000 * elapsed()), total), total);
  };
  PlannedRun chunk{&reference_method(settings.max_depth), kFirstChunk, 0, kFirstReferenceSeed};
  std::array<Half, 2> halves;
  std::uint64_t non_finite_samples = 0;
  while (chunk.spp >= kFirstChunk) {
    for (Half& half : halves) {
      const RenderResult result = render(scene, run_options(settings, chunk), stop, report);
      if (!result.complete) return std::nullopt;
      half.add(result.film, chunk.spp);
      non_finite_samples += result.non_finite_samples;
      ++chunk.seed;
    }
    const double affordable =
        (seconds / elapsed() - 1) * static_cast<double>(halves[0].spp);  // spp, of each half
    chunk.spp =
        affordable < kFirstChunk
            ? 0
            : std::min(2 * chunk.spp,
                       std::bit_floor(static_cast<std::uint64_t>(std::min(affordable, 1e15))));
  }
  const auto picture = [&](const Half& half) {
    return to_picture(settings.width, settings.height, half.mean());
  };
  ImageData joined = join_halves(picture(halves[0]), picture(halves[1]));
  RunFacts facts = planned_facts(settings, chunk);
  facts.spp = 2 * halves[0].spp;
  facts.seed.reset();
  facts.seeds = fmt::format("{} to {}", kFirstReferenceSeed, chunk.seed - 1);
  facts.render_seconds = elapsed();
  facts.complete = true;
  facts.non_finite_samples = non_finite_samples;
  joined.metadata = named_values(facts);
  return joined;
}

bool make_runs(const Scene& scene, const ChartSettings& settings, const GroundTruth& truth,
               RunLog& log, const std::atomic<bool>& stop, const ProgressCallback& progress) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(settings.width) * settings.height;
  std::vector<PlannedRun> missing;
  std::uint64_t total = 0, done = 0;
  for (const PlannedRun& run : plan_runs(settings)) {
    if (log.find(run.method->name, run.spp, run.repetition) != nullptr) continue;
    missing.push_back(run);
    total += run.spp * pixels;
  }
  for (const PlannedRun& run : missing) {
    const RenderResult result =
        render(scene, run_options(settings, run), stop, [&](std::uint64_t samples, std::uint64_t) {
          if (progress) progress(done + samples, total);
        });
    if (!result.complete) return false;
    done += run.spp * pixels;
    const RunFacts facts = facts_after(settings, run, result);
    ImageData picture = to_picture(settings.width, settings.height, means(result.film));
    picture.metadata = named_values(facts);
    OutputFile file(log.picture_path(run.method->name, run.spp, run.repetition));
    file.write(encode_image(picture, ImageFormat::exr));
    file.commit();
    log.add(measured(facts, run.repetition, picture, truth));
  }
  return true;
}

}  // namespace raytracing
