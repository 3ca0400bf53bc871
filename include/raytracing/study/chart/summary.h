#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "raytracing/study/chart/run_log.h"
#include "raytracing/study/chart/settings.h"
#include "raytracing/study/metrics/bias.h"
#include "raytracing/study/metrics/statistics.h"

namespace raytracing {

/// Median and extremes over the seeds.
struct Spread {
  double median, low, high;
};

/// One method at one number of samples, over the seeds.
struct ChartPoint {
  std::uint64_t spp;
  std::uint64_t seeds;
  Spread seconds, cpu_seconds, mse, relmse, smape;
  /// Less the noise floor; may be below 0. NaN when the floor is not known.
  Spread mse_corrected, relmse_corrected;
  std::uint64_t non_finite;  ///< samples of all seeds
  std::optional<BiasEstimate> bias;
  double error;  ///< median that curves, fits and tables use, see ChartSummary
  /// Whether `error` stands out from what is uncertain of the floor (two standard errors); else
  /// the point is no part of curves, fits and tables.
  bool measurable;
};

struct MethodSummary {
  const DirectMethod* method;
  std::vector<ChartPoint> points;  ///< rising spp
  std::vector<CurvePoint> curve;   ///< of the measurable points, by time
  /// Fits of the measurable medians.
  std::optional<PowerLaw> over_spp, over_time;

  /// That of the most samples: what is left when noise is not.
  const std::optional<BiasEstimate>& bias() const { return points.back().bias; }
};

/// What the finished runs of a chart show. "Error" is the median over the seeds of relMSE, less
/// the noise floor where that is known.
struct ChartSummary {
  std::optional<NoiseFloor> floor;
  std::vector<MethodSummary> methods;
  std::vector<double> times;   ///< of the table of equal time: 1, 2, 5, 10 ... within the curves
  std::vector<double> errors;  ///< of the table of equal error, falling
  struct FrontPoint {
    std::size_t method, point;  ///< indices
  };
  std::vector<FrontPoint> pareto_front;  ///< by time
};

Spread spread(const std::vector<double>& values);

/// The methods' curves, fits, tables and front follow from their points.
ChartSummary summarise(std::vector<MethodSummary> methods, std::optional<NoiseFloor> floor);

/// All runs of the plan must be in the log. Reads their pictures for the bias.
ChartSummary summarise_runs(const ChartSettings& settings, const RunLog& log,
                            const GroundTruth& truth);

/// The contents of summary.json, without the settings.
nlohmann::ordered_json to_json(const ChartSummary& summary);

}  // namespace raytracing
