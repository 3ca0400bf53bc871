#include "raytracing/study/chart/run_log.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"

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
  if (std::filesystem::exists(path)) {
    std::string_view text;
    const std::string bytes = read_file(path);
    text = bytes;
    if (!text.starts_with(run_csv_header() + "\n"))
      throw InputError(path + ": its first line is not that of a chart's runs");
    text.remove_prefix(run_csv_header().size() + 1);
    // Text after the last end of line belongs to a row that was cut off.
    for (std::size_t end; (end = text.find('\n')) != std::string_view::npos;
         text.remove_prefix(end + 1)) {
      const auto run = run_from_csv(text.substr(0, end));
      if (!run) continue;
      if (std::filesystem::exists(
              picture_path(*run->facts.light_sampling, *run->facts.spp, run->repetition)))
        runs_.push_back(*run);
      else
        ++dropped_;
    }
    if (dropped_ > 0) {
      OutputFile old(path + ".old");
      old.write(bytes);
      old.commit();
    }
  }
  OutputFile table(path);
  std::string rows = run_csv_header() + "\n";
  for (const ChartRun& run : runs_) rows += to_csv(run) + "\n";
  table.write(rows);
  table.commit();
  file_.reset(std::fopen(path.c_str(), "ab"));
  if (!file_) throw_not_written(path);
}

const ChartRun* RunLog::find(std::string_view method, std::uint64_t spp,
                             std::uint64_t repetition) const {
  for (const ChartRun& run : runs_)
    if (run.facts.light_sampling == method && run.facts.spp == spp && run.repetition == repetition)
      return &run;
  return nullptr;
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
  runs_.push_back(run);
}

}  // namespace raytracing
