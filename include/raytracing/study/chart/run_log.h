#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/render/provenance.h"

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
  /// Reads the table, if there is one, and removes rows that were cut off or have no picture; in
  /// the second case the old table is kept as runs.csv.old. Throws InputError for a file that is no
  /// such table, and OutputError.
  explicit RunLog(std::string folder);

  const std::vector<ChartRun>& runs() const { return runs_; }
  /// The number of rows that were removed because their picture is missing.
  std::size_t dropped() const { return dropped_; }
  const ChartRun* find(std::string_view method, std::uint64_t spp, std::uint64_t repetition) const;
  std::string picture_path(std::string_view method, std::uint64_t spp,
                           std::uint64_t repetition) const;
  /// Appends a row, which is on its way to the disk when this returns. Throws OutputError.
  void add(const ChartRun& run);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::string folder_;
  std::vector<ChartRun> runs_;
  std::size_t dropped_ = 0;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace raytracing
