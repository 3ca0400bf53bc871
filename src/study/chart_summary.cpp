#include "raytracing/study/chart_summary.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raytracing/io/image_reader.h"

namespace raytracing {
namespace {

ChartPoint point_of(std::uint64_t spp, const std::vector<const ChartRun*>& runs) {
  const auto spread_of = [&](double ChartRun::*field) {
    std::vector<double> values;
    for (const ChartRun* run : runs) values.push_back(run->*field);
    return spread(values);
  };
  const auto spread_of_fact = [&](std::optional<double> RunFacts::*field) {
    std::vector<double> values;
    for (const ChartRun* run : runs) values.push_back((run->facts.*field).value());
    return spread(values);
  };
  ChartPoint point{};
  point.spp = spp;
  point.seeds = runs.size();
  point.seconds = spread_of_fact(&RunFacts::render_seconds);
  point.cpu_seconds = spread_of_fact(&RunFacts::cpu_seconds);
  point.mse = spread_of(&ChartRun::mse);
  point.relmse = spread_of(&ChartRun::relmse);
  point.smape = spread_of(&ChartRun::smape);
  point.mse_corrected = spread_of(&ChartRun::mse_corrected);
  point.relmse_corrected = spread_of(&ChartRun::relmse_corrected);
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
  const auto [fastest, slowest] = std::minmax_element(
      all.begin(), all.end(),
      [](const CurvePoint& a, const CurvePoint& b) { return a.seconds < b.seconds; });
  summary.times = round_numbers(fastest->seconds, slowest->seconds);
  const auto [best, worst] = std::minmax_element(
      all.begin(), all.end(),
      [](const CurvePoint& a, const CurvePoint& b) { return a.error < b.error; });
  summary.errors = round_numbers(best->error, worst->error);
  std::reverse(summary.errors.begin(), summary.errors.end());
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
                            const Reference& reference, const PixelMask& counted) {
  std::vector<MethodSummary> methods;
  for (const DirectMethod* method : settings.methods) {
    MethodSummary& m = methods.emplace_back();
    m.method = method;
    for (const std::uint64_t spp : settings.spp) {
      std::vector<const ChartRun*> runs;
      SeedMoments moments;
      for (std::uint64_t repetition = 0; repetition < settings.seeds; ++repetition) {
        runs.push_back(log.find(method->name, spp, repetition));
        moments.add(read_image(log.picture_path(method->name, spp, repetition)));
      }
      ChartPoint& point = m.points.emplace_back(point_of(spp, runs));
      point.bias = estimate_bias(moments, reference, counted);
    }
  }
  return summarise(std::move(methods), noise_floor(reference, counted));
}

}  // namespace raytracing
