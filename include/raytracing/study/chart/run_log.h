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
/// that count; "corrected": less the noise floor of the reference, so that a single run may well be
/// below 0; NaN (an empty field) when the floor is not known.
struct ChartRun {
  RunFacts facts;
  std::uint64_t repetition = 0;
  double mse = 0, mse_corrected = 0;
  double relmse = 0, relmse_corrected = 0;
  double smape = 0;
  double largest = 0;  ///< of all channels of all pixels
};

/// The first line of runs.csv, without its end.
std::string run_csv_header();
std::string to_csv(const ChartRun& run);
/// Empty for a line that is none, for example one that was cut off.
std::optional<ChartRun> run_from_csv(std::string_view line);

/// The table <folder>/runs.csv and the pictures beside it in <folder>/runs/, one for each row.
/// A run is finished when it has both.
class RunLog {
 public:
  /// Reads what is there. Rows that were cut off or have no picture are taken out; in the second
  /// case the table as it was is kept as runs.csv.old. Throws InputError for a file that is not
  /// such a table, OutputError.
  explicit RunLog(std::string folder);

  const std::vector<ChartRun>& runs() const { return runs_; }
  /// Rows that were taken out because their picture is missing.
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
