#include "raytracing/study/chart/runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/io/film_image.h"

namespace raytracing {
namespace {

// The columns of a row behind the facts of scope run.
struct Measure {
  std::string_view name;
  double ChartRun::*member;
};
constexpr Measure kMeasures[] = {
    {"mse", &ChartRun::mse},       {"mse_corrected", &ChartRun::mse_corrected},
    {"relmse", &ChartRun::relmse}, {"relmse_corrected", &ChartRun::relmse_corrected},
    {"smape", &ChartRun::smape},   {"largest", &ChartRun::largest}};

template <class Visit>
void for_each_column(const Visit& visit) {
  for (const FactField& field : fact_fields())
    if (field.scope == FactScope::run) visit(field);
}

// Splits a line at its commas.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t comma; (comma = line.find(',')) != std::string_view::npos;
       line.remove_prefix(comma + 1))
    cells.push_back(line.substr(0, comma));
  cells.push_back(line);
  return cells;
}

template <class Number>
bool read_number(std::string_view text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return stop == end && error == std::errc();
}

[[noreturn]] void throw_not_written(const std::string& path) {
  throw OutputError(path + ": cannot be written");
}

constexpr std::uint64_t kFirstChunk = 16;  // samples per pixel

// Adds the samples of another film to one of the same size.
void add(Film& film, const Film& more) {
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      Film::Pixel& pixel = film.at(x, y);
      const Film::Pixel& other = more.at(x, y);
      pixel.sum += other.sum;
      pixel.sum_of_squares += other.sum_of_squares;
      pixel.samples += other.samples;
      pixel.replicates += other.replicates;
      pixel.counted += other.counted;
    }
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

std::string run_csv_header() {
  std::string line;
  for_each_column([&line](const FactField& field) { line += std::string(field.name) + ","; });
  line += "repetition";
  for (const Measure& measure : kMeasures) line += "," + std::string(measure.name);
  return line;
}

std::string to_csv(const ChartRun& run) {
  std::string line;
  for_each_column([&](const FactField& field) {
    if (const auto value = fact_value(run.facts, field)) line += to_text(*value);
    line += ',';
  });
  line += std::to_string(run.repetition);
  for (const Measure& measure : kMeasures) {
    const double value = run.*measure.member;
    line += std::isnan(value) ? "," : fmt::format(",{}", value);
  }
  return line;
}

std::optional<ChartRun> run_from_csv(std::string_view line) {
  const std::vector<std::string_view> cells = cells_of(line);
  if (cells.size() != cells_of(run_csv_header()).size()) return std::nullopt;
  ChartRun run;
  bool good = true;
  auto cell = cells.begin();
  for_each_column([&](const FactField& field) {
    read_fact(run.facts, field, *cell);
    good = good && (cell->empty() || fact_value(run.facts, field));
    ++cell;
  });
  good = good && read_number(*cell++, run.repetition);
  for (const Measure& measure : kMeasures) {
    run.*measure.member = std::numeric_limits<double>::quiet_NaN();
    good = good && (cell->empty() || read_number(*cell, run.*measure.member));
    ++cell;
  }
  const RunFacts& facts = run.facts;
  if (!good || !facts.light_sampling || !facts.spp || !facts.render_seconds || !facts.cpu_seconds)
    return std::nullopt;
  return run;
}

RunLog::RunLog(std::string folder) : folder_(std::move(folder)) {
  const std::string path = folder_ + "/runs.csv";
  std::error_code error;
  std::filesystem::create_directories(folder_ + "/runs", error);
  if (error) throw_not_written(folder_ + "/runs");
  if (std::filesystem::exists(path)) read_table(path);
  std::string rows = run_csv_header() + "\n";
  for (const ChartRun& run : runs_) rows += to_csv(run) + "\n";
  write_file(path, rows);
  file_.reset(std::fopen(path.c_str(), "ab"));
  if (!file_) throw_not_written(path);
}

void RunLog::read_table(const std::string& path) {
  const std::string bytes = read_file(path);
  std::string_view text = bytes;
  if (!text.starts_with(run_csv_header() + "\n"))
    throw InputError(path + ": its first line is not that of a chart's runs");
  std::size_t unreadable = 0, first_unreadable = 0, without_picture = 0;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    const auto run = run_from_csv(text.substr(0, end));
    const bool cut_off = end == std::string_view::npos;
    text.remove_prefix(cut_off ? text.size() : end + 1);
    if (line == 1) continue;  // the header
    if (!run || cut_off) {
      if (++unreadable == 1) first_unreadable = line;
    } else if (std::filesystem::exists(
                   picture_path(*run->facts.light_sampling, *run->facts.spp, run->repetition))) {
      insert(*run);
    } else {
      ++without_picture;
    }
  }
  if (unreadable + without_picture == 0) return;
  std::string old = path + ".old";
  for (int number = 2; std::filesystem::exists(old); ++number)
    old = fmt::format("{}.old{}", path, number);
  write_file(old, bytes);
  const std::string again = fmt::format("rendered again; the old table is kept as {}",
                                        std::filesystem::path(old).filename().string());
  if (unreadable > 0)
    warnings_.push_back(fmt::format("{}:{}: incomplete row ({} in all); {}", path, first_unreadable,
                                    unreadable, again));
  if (without_picture > 0)
    warnings_.push_back(
        fmt::format("{}: rows without a picture in runs/: {}; {}", path, without_picture, again));
}

void RunLog::insert(const ChartRun& run) {
  index_.emplace(Key(*run.facts.light_sampling, *run.facts.spp, run.repetition), runs_.size());
  runs_.push_back(run);
}

const ChartRun* RunLog::find(std::string_view method, std::uint64_t spp,
                             std::uint64_t repetition) const {
  const auto found = index_.find(Key(method, spp, repetition));
  return found == index_.end() ? nullptr : &runs_[found->second];
}

const ChartRun& RunLog::at(std::string_view method, std::uint64_t spp,
                           std::uint64_t repetition) const {
  if (const ChartRun* run = find(method, spp, repetition)) return *run;
  throw std::out_of_range(
      fmt::format("{}/runs.csv lacks {} at {} spp, {}", folder_, method, spp, repetition));
}

std::string RunLog::picture_path(std::string_view method, std::uint64_t spp,
                                 std::uint64_t repetition) const {
  return fmt::format("{}/runs/{}_{}_{}.exr", folder_, method, spp, repetition);
}

void RunLog::add(const ChartRun& run) {
  const std::string line = to_csv(run) + "\n";
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() ||
      std::fflush(file_.get()) != 0)
    throw_not_written(folder_ + "/runs.csv");
  insert(run);
}

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
  std::array<Film, 2> halves{Film(settings.width, settings.height),
                             Film(settings.width, settings.height)};
  std::uint64_t spp = 0;  // of each half
  std::uint64_t non_finite_samples = 0;
  while (chunk.spp >= kFirstChunk) {
    for (Film& half : halves) {
      const RenderResult result = render(scene, run_options(settings, chunk), stop, report);
      if (!result.complete) return std::nullopt;
      add(half, result.film);
      non_finite_samples += result.non_finite_samples;
      ++chunk.seed;
    }
    spp += chunk.spp;
    const double affordable = (seconds / elapsed() - 1) * static_cast<double>(spp);
    chunk.spp =
        affordable < kFirstChunk
            ? 0
            : std::min(2 * chunk.spp,
                       std::bit_floor(static_cast<std::uint64_t>(std::min(affordable, 1e15))));
  }
  ImageData joined = join_halves(to_image(halves[0], {}), to_image(halves[1], {}));
  RunFacts facts = planned_facts(settings, chunk);
  facts.spp = 2 * spp;
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
    RunFacts facts = planned_facts(settings, run);
    add_result(facts, run_options(settings, run), result);
    const ImageData picture = to_image(result.film, facts);
    write_file(log.picture_path(run.method->name, run.spp, run.repetition),
               encode_image(picture, "exr"));
    log.add(measured(facts, run.repetition, picture, truth));
  }
  return true;
}

}  // namespace raytracing
