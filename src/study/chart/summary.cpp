#include "raytracing/study/chart/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "raytracing/io/image.h"

namespace raytracing {
namespace {

// A number of each run, and its spread over the seeds.
struct SpreadField {
  const char* name;  // in summary.json
  Spread ChartPoint::*spread;
  double (*of)(const ChartRun& run);
};
constexpr SpreadField kSpreads[] = {
    {"seconds", &ChartPoint::seconds, [](const ChartRun& r) { return *r.facts.render_seconds; }},
    {"cpu_seconds", &ChartPoint::cpu_seconds,
     [](const ChartRun& r) { return *r.facts.cpu_seconds; }},
    {"mse", &ChartPoint::mse, [](const ChartRun& r) { return r.mse; }},
    {"mse_corrected", &ChartPoint::mse_corrected,
     [](const ChartRun& r) { return r.mse_corrected; }},
    {"relmse", &ChartPoint::relmse, [](const ChartRun& r) { return r.relmse; }},
    {"relmse_corrected", &ChartPoint::relmse_corrected,
     [](const ChartRun& r) { return r.relmse_corrected; }},
    {"smape", &ChartPoint::smape, [](const ChartRun& r) { return r.smape; }},
};

ChartPoint point_of(std::uint64_t spp, const std::vector<const ChartRun*>& runs) {
  ChartPoint point{};
  point.spp = spp;
  point.seeds = runs.size();
  for (const SpreadField& field : kSpreads) {
    std::vector<double> values;
    for (const ChartRun* run : runs) values.push_back(field.of(*run));
    point.*field.spread = spread(values);
  }
  for (const ChartRun* run : runs) point.non_finite += run->facts.non_finite_samples.value_or(0);
  return point;
}

void add_curve_and_fits(MethodSummary& method, const std::optional<NoiseFloor>& floor) {
  std::vector<double> spp, seconds, errors;
  for (ChartPoint& point : method.points) {
    point.error = floor ? point.relmse_corrected.median : point.relmse.median;
    point.measurable = point.error > (floor ? 2 * floor->relmse.standard_error : 0);
    if (!point.measurable) continue;
    spp.push_back(static_cast<double>(point.spp));
    seconds.push_back(point.seconds.median);
    errors.push_back(point.error);
    method.curve.push_back({point.seconds.median, point.error});
  }
  method.curve = by_time(method.curve);
  method.over_spp = fit_power_law(spp, errors);
  method.over_time = fit_power_law(seconds, errors);
}

void add_tables(ChartSummary& summary) {
  std::vector<CurvePoint> all;
  std::vector<ChartSummary::FrontPoint> places;
  for (std::size_t m = 0; m < summary.methods.size(); ++m)
    for (std::size_t p = 0; p < summary.methods[m].points.size(); ++p) {
      const ChartPoint& point = summary.methods[m].points[p];
      if (!point.measurable) continue;
      all.push_back({point.seconds.median, point.error});
      places.push_back({m, p});
    }
  if (all.empty()) return;
  for (const std::size_t i : pareto_front(all)) summary.pareto_front.push_back(places[i]);
  std::vector<double> seconds, errors;
  for (const CurvePoint& point : all) {
    seconds.push_back(point.seconds);
    errors.push_back(point.error);
  }
  const auto add_levels = [&](const std::vector<double>& within, const auto& value_at,
                              std::vector<ChartSummary::Level>& levels) {
    const auto [low, high] = std::minmax_element(within.begin(), within.end());
    for (const double at : round_numbers(*low, *high)) {
      ChartSummary::Level& level = levels.emplace_back(ChartSummary::Level{at, {}});
      for (const MethodSummary& m : summary.methods) level.values.push_back(value_at(m.curve, at));
    }
  };
  add_levels(seconds, error_at, summary.equal_time);
  add_levels(errors, time_to, summary.equal_error);
  std::reverse(summary.equal_error.begin(), summary.equal_error.end());
}

// The functions below make summary.json.

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json(const Spread& s) {
  return {{"median", number(s.median)}, {"min", number(s.low)}, {"max", number(s.high)}};
}

Json json(const Estimate& e) {
  return {{"value", number(e.value)}, {"standard_error", number(e.standard_error)}};
}

Json json(const std::optional<PowerLaw>& fit) {
  if (!fit) return nullptr;
  Json j;
  j["slope"] = fit->slope;
  j["slope_95"] = nullptr;
  if (fit->slope_interval) j["slope_95"] = {fit->slope_interval->low, fit->slope_interval->high};
  j["points"] = fit->points;
  return j;
}

Json json(const std::optional<BiasEstimate>& bias) {
  if (!bias) return nullptr;
  Json j;
  j["rms"] = bias->rms();
  j["rms_95"] = {bias->rms_low(), bias->rms_high()};
  j["squared"] = json(bias->squared);
  j["relative_squared"] = json(bias->relative_squared);
  j["mean_ratio_minus_1"] = json(bias->mean_ratio);
  j["detected"] = bias->detected;
  return j;
}

Json json(const ChartPoint& p) {
  Json j;
  j["spp"] = p.spp;
  j["seeds"] = p.seeds;
  for (const SpreadField& field : kSpreads) j[field.name] = json(p.*field.spread);
  j["above_floor"] = p.measurable;
  j["non_finite_samples"] = p.non_finite;
  j["bias"] = json(p.bias);
  return j;
}

Json json(const MethodSummary& m) {
  Json j;
  j["method"] = m.method->name;
  j["unbiased_by_design"] = m.method->unbiased;
  j["fit_over_spp"] = json(m.over_spp);
  j["fit_over_seconds"] = json(m.over_time);
  j["bias"] = json(m.bias());
  for (const ChartPoint& point : m.points) j["points"].push_back(json(point));
  return j;
}

// The levels with their values by the names of the methods.
Json json(const ChartSummary& s, const std::vector<ChartSummary::Level>& levels, const char* at,
          const char* value) {
  Json rows = Json::array();
  for (const ChartSummary::Level& level : levels) {
    Json& row = rows.emplace_back(Json{{at, level.at}});
    for (std::size_t m = 0; m < s.methods.size(); ++m)
      row[value][std::string(s.methods[m].method->name)] =
          level.values[m] ? number(*level.values[m]) : Json(nullptr);
  }
  return rows;
}

// Defines every number, for readers who have only the file.
Json definitions() {
  return {
      {"mse", "mean over pixels and channels of (x-r)^2"},
      {"relmse", relmse_formula() + " over pixels and channels"},
      {"smape",
       fmt::format("mean over pixels and channels of |x-r| / (|x| + |r| + {})", kRelMseEpsilon)},
      {"corrected", "less noise_floor; not clamped, so that it may be negative"},
      {"seconds", "wall clock of the rendering, without loading the scene and writing the picture"},
      {"above_floor",
       "the median of relmse_corrected is above twice the standard error of the "
       "floor; only such points go into fits, tables and front. Without a known "
       "floor relmse takes the place of relmse_corrected"},
      {"fit",
       "least squares through (log spp or median seconds, log median error); 95 % interval "
       "by Student's t with points-2 degrees of freedom, from the scatter of the medians "
       "about the line"},
      {"equal_time, equal_error",
       "interpolated between the medians in (log seconds, log error); "
       "null outside of what was measured: nothing is extrapolated. "
       "Seconds to an error are null, too, when the first point is "
       "already below it"},
      {"bias",
       fmt::format(
           "squared = mean of (X-r)^2 - S^2/N - V, with X the mean and S^2 the variance over N "
           "seeds, r the reference, V its squared error; rms = sqrt(max(0, squared)). "
           "relative_squared has the weights of relmse. mean_ratio_minus_1 = sum X / sum r - 1. "
           "detected: relative_squared above {} or mean_ratio_minus_1 beyond {} standard errors; "
           "an "
           "unbiased method has a chance of at most 1 in 100 of that. The method's bias is that at "
           "the most spp",
           kOneSidedHalfPercent, kTwoSidedHalfPercent)}};
}

}  // namespace

Spread spread(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {median(values), *low, *high};
}

ChartSummary summarise(std::vector<MethodSummary> methods, std::optional<NoiseFloor> floor) {
  ChartSummary summary;
  summary.floor = floor;
  summary.methods = std::move(methods);
  for (MethodSummary& method : summary.methods) add_curve_and_fits(method, floor);
  add_tables(summary);
  return summary;
}

ChartSummary summarise_runs(const ChartSettings& settings, const RunLog& log,
                            const GroundTruth& truth) {
  std::vector<MethodSummary> methods;
  for (const DirectMethod* method : settings.methods) {
    MethodSummary& m = methods.emplace_back();
    m.method = method;
    for (const std::uint64_t spp : settings.spp) {
      std::vector<const ChartRun*> runs;
      SeedMoments moments;
      for (std::uint64_t repetition = 0; repetition < settings.seeds; ++repetition) {
        runs.push_back(&log.at(method->name, spp, repetition));
        moments.add(read_image(log.picture_path(method->name, spp, repetition)));
      }
      ChartPoint& point = m.points.emplace_back(point_of(spp, runs));
      point.bias = estimate_bias(moments, truth.reference, truth.counted);
    }
  }
  return summarise(std::move(methods), truth.floor);
}

nlohmann::ordered_json to_json(const ChartSummary& s) {
  Json j;
  j["definitions"] = definitions();
  j["noise_floor"] = nullptr;
  if (s.floor) j["noise_floor"] = {{"mse", json(s.floor->mse)}, {"relmse", json(s.floor->relmse)}};
  for (const MethodSummary& method : s.methods) j["methods"].push_back(json(method));
  j["equal_time"] = json(s, s.equal_time, "seconds", "relmse");
  j["equal_error"] = json(s, s.equal_error, "relmse", "seconds");
  j["pareto_front"] = Json::array();
  for (const auto& [method, point] : s.pareto_front) {
    const ChartPoint& p = s.methods[method].points[point];
    j["pareto_front"].push_back({{"method", s.methods[method].method->name},
                                 {"spp", p.spp},
                                 {"seconds", p.seconds.median},
                                 {"relmse", p.error}});
  }
  return j;
}

}  // namespace raytracing
