#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "raytracing/study/chart/runs.h"
#include "raytracing/study/chart/settings.h"
#include "raytracing/study/metrics/reference.h"
#include "raytracing/study/metrics/statistics.h"

namespace raytracing {

/// The median and the extremes over the seeds.
struct Spread {
  double median, low, high;
};

/// The results of one method at one sample count, over the seeds.
struct ChartPoint {
  std::uint64_t spp;
  std::uint64_t seeds;
  Spread seconds, cpu_seconds, mse, relmse, smape;
  /// The errors less the noise floor, perhaps negative; NaN when the floor is not known.
  Spread mse_corrected, relmse_corrected;
  std::uint64_t non_finite;  ///< non-finite samples of all seeds
  std::optional<BiasEstimate> bias;
  double error;  ///< the median for curves, fits and tables; see ChartSummary
  /// Whether `error` exceeds the uncertainty of the floor (two standard errors); other points are
  /// left out of curves, fits and tables.
  bool measurable;
};

struct MethodSummary {
  const DirectMethod* method;
  std::vector<ChartPoint> points;  ///< rising spp
  std::vector<CurvePoint> curve;   ///< of the measurable points, by time
  /// Fits of the measurable medians.
  std::optional<PowerLaw> over_spp, over_time;

  /// The bias at the most samples, where the noise is least.
  const std::optional<BiasEstimate>& bias() const { return points.back().bias; }
};

/// The results of the finished runs of a chart. "Error" is the median over the seeds of relMSE,
/// less the noise floor where that is known.
struct ChartSummary {
  std::optional<NoiseFloor> floor;
  std::vector<MethodSummary> methods;
  /// A time or an error, and the value of each method there; empty where nothing was measured.
  struct Level {
    double at;
    std::vector<std::optional<double>> values;
  };
  std::vector<Level> equal_time;   ///< errors at 1, 2, 5, 10 ... seconds within the curves
  std::vector<Level> equal_error;  ///< seconds to an error, from the largest error on
  struct FrontPoint {
    std::size_t method, point;  ///< indices
  };
  std::vector<FrontPoint> pareto_front;  ///< by time
};

Spread spread(const std::vector<double>& values);

/// Computes the methods' curves and fits, the tables and the front from the methods' points.
ChartSummary summarise(std::vector<MethodSummary> methods, std::optional<NoiseFloor> floor);

/// Summarises the runs of the plan, all of which must be in the log. Reads their pictures to
/// estimate the bias.
ChartSummary summarise_runs(const ChartSettings& settings, const RunLog& log,
                            const GroundTruth& truth);

/// The contents of summary.json, without the settings.
nlohmann::ordered_json to_json(const ChartSummary& summary);

}  // namespace raytracing
