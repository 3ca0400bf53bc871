#include "raytracing/study/run_log.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"

namespace raytracing {
namespace {

constexpr std::string_view kHeader =
    "method,spp,repetition,seed,render_seconds,cpu_seconds,rays_closest,rays_shadow,"
    "segment_queries,mse,mse_corrected,relmse,relmse_corrected,smape,mean_r,mean_g,mean_b,"
    "non_finite_samples,largest";

// Visits every field of the row in the order of the header.
template <class Run, class F>
void visit_fields(Run& r, const F& f) {
  f(r.method), f(r.spp), f(r.repetition), f(r.seed), f(r.render_seconds), f(r.cpu_seconds);
  f(r.rays.closest), f(r.rays.shadow), f(r.rays.segments), f(r.mse), f(r.mse_corrected);
  f(r.relmse), f(r.relmse_corrected), f(r.smape), f(r.mean.x), f(r.mean.y), f(r.mean.z);
  f(r.non_finite), f(r.largest);
}

/// Takes one field after the other from a line.
class FieldReader {
 public:
  explicit FieldReader(std::string_view line) : rest_(line) {}

  void operator()(std::string& field) { field = next(); }
  void operator()(std::uint64_t& field) { read(next(), field); }
  void operator()(double& field) {
    const std::string_view text = next();
    field = std::numeric_limits<double>::quiet_NaN();
    if (!text.empty()) read(text, field);
  }
  bool all_read() const { return good_ && ended_; }

 private:
  std::string_view next() {
    if (ended_) good_ = false;
    const std::size_t comma = rest_.find(',');
    const std::string_view field = rest_.substr(0, comma);
    ended_ = comma == std::string_view::npos;
    rest_ = ended_ ? std::string_view() : rest_.substr(comma + 1);
    return field;
  }
  template <class Number>
  void read(std::string_view text, Number& field) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, field);
    if (stop != end || error != std::errc()) good_ = false;
  }

  std::string_view rest_;
  bool ended_ = false, good_ = true;
};

[[noreturn]] void throw_not_written(const std::string& path) {
  throw OutputError(path + ": cannot be written");
}

}  // namespace

std::string run_csv_header() { return std::string(kHeader); }

std::string to_csv(const ChartRun& run) {
  std::string line;
  visit_fields(run, [&line](const auto& field) {
    if (!line.empty()) line += ',';
    if constexpr (std::is_same_v<std::decay_t<decltype(field)>, double>) {
      if (!std::isnan(field)) line += fmt::format("{}", field);
    } else {
      line += fmt::format("{}", field);
    }
  });
  return line;
}

std::optional<ChartRun> run_from_csv(std::string_view line) {
  ChartRun run;
  FieldReader reader(line);
  visit_fields(run, [&reader](auto& field) { reader(field); });
  if (!reader.all_read()) return std::nullopt;
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
    text.remove_prefix(kHeader.size() + 1);
    // What follows the last line's end was cut off.
    for (std::size_t end; (end = text.find('\n')) != std::string_view::npos;
         text.remove_prefix(end + 1)) {
      const auto run = run_from_csv(text.substr(0, end));
      if (!run) continue;
      if (std::filesystem::exists(picture_path(run->method, run->spp, run->repetition)))
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
    if (run.method == method && run.spp == spp && run.repetition == repetition) return &run;
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
