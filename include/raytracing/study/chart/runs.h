#pragma once

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "raytracing/study/chart/settings.h"
#include "raytracing/study/metrics/reference.h"

namespace raytracing {

/// One run of a chart: its facts and its errors. Errors are against the reference, over the pixels
/// that count. Corrected errors are less the noise floor of the reference and may be negative; NaN
/// (an empty field) when the floor is not known.
struct ChartRun {
  RunFacts facts;
  std::uint64_t repetition = 0;
  double mse = 0, mse_corrected = 0;
  double relmse = 0, relmse_corrected = 0;
  double smape = 0;
  double largest = 0;  ///< value of all channels of all pixels
};

/// The first line of runs.csv, without its end.
std::string run_csv_header();
std::string to_csv(const ChartRun& run);
/// Reads a row; empty for a faulty line, for example one that was cut off.
std::optional<ChartRun> run_from_csv(std::string_view line);

/// The table <folder>/runs.csv and the pictures beside it in <folder>/runs/, one for each row.
/// A run is finished when it has both.
class RunLog {
 public:
  /// Reads the table, if there is one, and removes rows that cannot be read, as one that was cut
  /// off, and rows without a picture; the old table is then kept as runs.csv.old, or .old2 and so
  /// on where that exists. Throws InputError for a file that is no such table, and OutputError.
  explicit RunLog(std::string folder);

  const std::vector<ChartRun>& runs() const { return runs_; }
  /// What was removed and why, one line each; empty when nothing was.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// The run, or null when it is not finished. Valid until the next add().
  const ChartRun* find(std::string_view method, std::uint64_t spp, std::uint64_t repetition) const;
  /// The finished run. Throws std::out_of_range when it is not finished.
  const ChartRun& at(std::string_view method, std::uint64_t spp, std::uint64_t repetition) const;
  std::string picture_path(std::string_view method, std::uint64_t spp,
                           std::uint64_t repetition) const;
  /// Appends a row, which is on its way to the disk when this returns. Throws OutputError.
  void add(const ChartRun& run);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  using Key = std::tuple<std::string, std::uint64_t, std::uint64_t>;  // method, spp, repetition

  void read_table(const std::string& path);
  void insert(const ChartRun& run);

  std::string folder_;
  std::vector<ChartRun> runs_;        // in the order of the table
  std::map<Key, std::size_t> index_;  // into runs_
  std::vector<std::string> warnings_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// The method that renders the reference. For direct light only it is `line`, whose error falls
/// fastest. Otherwise it is `point`: the noise then comes from the bounces, of which it renders the
/// most per second (in the Cornell box its variance times time is two thirds of that of `line`),
/// and it shares no code with the line methods under test.
const DirectMethod& reference_method(const std::optional<std::uint32_t>& max_depth);

/// Renders two halves in turns, with seeds that no run of a chart uses, in chunks of 16, 32, 64 ...
/// samples per pixel until `seconds` have passed, at least one chunk each. The picture has the
/// layers of join_halves(). Empty when stopped.
std::optional<ImageData> render_reference(const Scene& scene, const ChartSettings& settings,
                                          double seconds, const std::atomic<bool>& stop,
                                          const ProgressCallback& progress);

/// Renders and measures the planned runs that are not in the log yet, and adds the picture and the
/// row of each to the log. `progress` counts the samples of these runs. False when stopped;
/// finished runs are kept.
bool make_runs(const Scene& scene, const ChartSettings& settings, const GroundTruth& truth,
               RunLog& log, const std::atomic<bool>& stop, const ProgressCallback& progress);

}  // namespace raytracing
