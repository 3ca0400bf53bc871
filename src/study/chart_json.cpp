#include <cmath>
#include <nlohmann/json.hpp>

#include "raytracing/study/chart_summary.h"
#include "raytracing/study/error_metrics.h"

namespace raytracing {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json optional_number(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

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
  j["seconds"] = json(p.seconds);
  j["cpu_seconds"] = json(p.cpu_seconds);
  j["mse"] = json(p.mse);
  j["mse_corrected"] = json(p.mse_corrected);
  j["relmse"] = json(p.relmse);
  j["relmse_corrected"] = json(p.relmse_corrected);
  j["smape"] = json(p.smape);
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

// How every number came about, for whom the file reaches without us.
Json definitions() {
  return {
      {"mse", "mean over pixels and channels of (x-r)^2"},
      {"relmse", relmse_formula() + " over pixels and channels"},
      {"smape", "mean over pixels and channels of |x-r| / (|x| + |r| + 0.01)"},
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
       "squared = mean of (X-r)^2 - S^2/N - V, with X the mean and S^2 the variance over "
       "N seeds, r the reference, V its squared error; rms = sqrt(max(0, squared)). "
       "relative_squared has the weights of relmse. mean_ratio_minus_1 = sum X / sum r "
       "- 1. detected: relative_squared above 2.576 or mean_ratio_minus_1 beyond 2.807 "
       "standard errors; an unbiased method has a chance of at most 1 in 100 of that. The "
       "method's bias is that at the most spp"}};
}

}  // namespace

nlohmann::ordered_json to_json(const ChartSummary& s) {
  Json j;
  j["definitions"] = definitions();
  j["noise_floor"] = nullptr;
  if (s.floor) j["noise_floor"] = {{"mse", json(s.floor->mse)}, {"relmse", json(s.floor->relmse)}};
  for (const MethodSummary& method : s.methods) j["methods"].push_back(json(method));
  j["equal_time"] = Json::array();
  for (const double seconds : s.times) {
    Json row{{"seconds", seconds}};
    for (const MethodSummary& m : s.methods)
      row["relmse"][std::string(m.method->name)] = optional_number(error_at(m.curve, seconds));
    j["equal_time"].push_back(row);
  }
  j["equal_error"] = Json::array();
  for (const double error : s.errors) {
    Json row{{"relmse", error}};
    for (const MethodSummary& m : s.methods)
      row["seconds"][std::string(m.method->name)] = optional_number(time_to(m.curve, error));
    j["equal_error"].push_back(row);
  }
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
