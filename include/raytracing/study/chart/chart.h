#pragma once

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "raytracing/study/chart/settings.h"

namespace raytracing {

/// The settings of a chart, and its reference and mask.
struct ChartRequest {
  ChartSettings settings;
  std::string reference = "auto";  ///< path of an EXR picture; "auto": rendered and kept
  double reference_seconds = 60;   ///< rendering time of an automatic reference
  std::string mask;                ///< path of a picture; "" = every pixel counts
};

/// Receives what happens while a chart is made.
class ChartListener {
 public:
  virtual ~ChartListener() = default;
  /// One line about the work, without its end.
  virtual void note(const std::string& line) = 0;
  virtual void warn(const std::string& line) = 0;
  /// A file of the chart's folder is complete.
  virtual void file_written(const std::string& name) = 0;
  /// A longer rendering begins, goes on and ends, completely or not.
  virtual void progress_began() = 0;
  virtual void progress(std::uint64_t done, std::uint64_t total) = 0;
  virtual void progress_ended(bool complete) = 0;
};

enum class ChartEnd { complete, stopped_in_reference, stopped_in_runs };

/// Renders the reference and all runs that the folder does not hold yet, and writes tables, charts
/// and report.html. The folder belongs to one set of settings. When `stop` becomes true, returns
/// soon; finished runs and a finished reference are kept. Throws InputError and OutputError; a
/// failure of gnuplot is thrown after all else is written.
ChartEnd make_chart(const Scene& scene, const ChartRequest& request, const std::atomic<bool>& stop,
                    ChartListener& listener);

}  // namespace raytracing
