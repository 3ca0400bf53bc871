#include "raytracing/study/chart/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "raytracing/io/file.h"
#include "raytracing/io/image.h"
#include "raytracing/study/metrics/error_metrics.h"
#include "raytracing/study/metrics/error_picture.h"
#include "raytracing/study/page/result_folder.h"

namespace raytracing {
namespace {

// The longest time up to which every method has been measured.
double common_time(const ChartSummary& summary) {
  double time = INFINITY;
  for (const MethodSummary& m : summary.methods) {
    double longest = 0;
    for (const ChartPoint& p : m.points) longest = std::max(longest, p.seconds.median);
    time = std::min(time, longest);
  }
  return time;
}

// The method's point of the most samples within that time; its first point where all take longer.
const ChartPoint& best_within(const MethodSummary& method, double seconds) {
  const ChartPoint* best = &method.points.front();
  for (const ChartPoint& p : method.points)
    if (p.seconds.median <= seconds && p.spp > best->spp) best = &p;
  return *best;
}

// A PNG without a header, since the page lists the facts.
std::string png(const ImageData& image) {
  return encode_image({image.width, image.height, image.channels, image.values, {}}, "png");
}

ReportPicture picture_of(const MethodSummary& method, double seconds, const RunLog& log,
                         const GroundTruth& truth) {
  const ChartPoint& point = best_within(method, seconds);
  const std::string_view name = method.method->name;
  const ChartRun& run = log.at(name, point.spp, 0);
  const ImageData image = read_image(log.picture_path(name, point.spp, 0));
  return {method_label(*method.method),
          fmt::format("{} spp in {:.3g} s (median), of at most {:.3g} s; relMSE {:.3g}", point.spp,
                      point.seconds.median, seconds, run.relmse),
          png(image), png(error_map(image, truth.reference.picture, truth.counted))};
}

std::vector<ReportPicture> pictures(const ChartSummary& summary, const RunLog& log,
                                    const GroundTruth& truth) {
  std::vector<ReportPicture> result;
  for (const MethodSummary& method : summary.methods)
    result.push_back(picture_of(method, common_time(summary), log, truth));
  const std::string noise =
      summary.floor ? fmt::format("its own relMSE is about {:.2g}", summary.floor->relmse.value)
                    : "its own noise is not known";
  result.push_back({"reference", noise, png(truth.reference.picture), ""});
  return result;
}

// A sentence on the ranks of the methods at a time at which all were measured.
std::string best_at(const ChartSummary& summary, const ChartSummary::Level& level) {
  std::vector<std::pair<double, std::string_view>> ranks;
  for (std::size_t m = 0; m < summary.methods.size(); ++m)
    ranks.emplace_back(level.values[m].value(), summary.methods[m].method->name);
  std::sort(ranks.begin(), ranks.end());
  std::string text =
      fmt::format("In {:.3g} s, the least relMSE (median over the seeds) is that of {}: {:.3g}",
                  level.at, ranks.front().second, ranks.front().first);
  for (std::size_t i = 1; i < ranks.size(); ++i)
    text += fmt::format("{} {} has {:.2f} times as much", i == 1 ? ";" : ",", ranks[i].second,
                        ranks[i].first / ranks[0].first);
  return text + ".";
}

std::vector<std::string> notes(const ChartSummary& summary) {
  std::vector<std::string> result;
  std::vector<ChartSummary::Level> common;  // times at which all methods were measured
  std::copy_if(summary.equal_time.begin(), summary.equal_time.end(), std::back_inserter(common),
               [](const ChartSummary::Level& level) {
                 return std::all_of(level.values.begin(), level.values.end(),
                                    [](const auto& value) { return value.has_value(); });
               });
  if (!common.empty()) result.push_back(best_at(summary, common.front()));
  if (common.size() > 1) result.push_back(best_at(summary, common.back()));
  for (const MethodSummary& m : summary.methods)
    if (m.bias() && m.bias()->detected)
      result.push_back(fmt::format("{}: {}.", m.method->name, to_text(*m.bias())));
  result.push_back(
      "Methods whose bands overlap in the charts cannot be ranked by so few seeds. relMSE is "
      "the " +
      relmse_formula() +
      " over pixels and channels, with x the picture and r the reference. The error maps show it "
      "per pixel, on a logarithmic scale: " +
      error_colours() + ".");
  return result;
}

// The tables: equal time, equal error, fits and bias, Pareto front, and all points.

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "-";
}

std::string cell(const Spread& s) {
  return fmt::format("{:.3g} ({:.3g} to {:.3g})", s.median, s.low, s.high);
}

std::string slope_cell(const std::optional<PowerLaw>& fit) {
  if (!fit) return "-";
  if (!fit->slope_interval) return fmt::format("{:.2f}", fit->slope);
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", fit->slope, fit->slope_interval->low,
                     fit->slope_interval->high);
}

ReportTable level_table(const char* caption, const char* at, const ChartSummary& summary,
                        const std::vector<ChartSummary::Level>& levels) {
  ReportTable table{caption, {at}, {}};
  for (const MethodSummary& m : summary.methods) table.header.emplace_back(m.method->name);
  for (const ChartSummary::Level& level : levels) {
    auto& row = table.rows.emplace_back(1, cell(level.at));
    for (const auto& value : level.values) row.push_back(cell(value));
  }
  return table;
}

std::vector<std::string> bias_cells(const std::optional<BiasEstimate>& bias) {
  if (!bias) return {"-", "-", "not known"};
  const Estimate &level = bias->relative_squared, &mean = bias->mean_ratio;
  return {fmt::format("{:.2g} ± {:.1g}", level.value, kNormal95 * level.standard_error),
          fmt::format("{:+.2f} ± {:.2f}", 100 * mean.value, 100 * kNormal95 * mean.standard_error),
          bias->detected ? "yes" : "no"};
}

ReportTable fits(const ChartSummary& summary) {
  ReportTable table{"Slopes of log relMSE, and bias at the most samples, with 95 % intervals",
                    {"method", "slope over spp", "slope over seconds", "relMSE of the bias",
                     "mean difference, %", "bias detected"},
                    {}};
  for (const MethodSummary& m : summary.methods) {
    auto& row = table.rows.emplace_back();
    row = {std::string(m.method->name), slope_cell(m.over_spp), slope_cell(m.over_time)};
    for (std::string& text : bias_cells(m.bias())) row.push_back(std::move(text));
  }
  return table;
}

ReportTable pareto_front(const ChartSummary& summary) {
  ReportTable table{"Pareto front: no other measurement is better in both time and error",
                    {"seconds", "relMSE", "method", "spp"},
                    {}};
  for (const auto& [m, p] : summary.pareto_front) {
    const MethodSummary& method = summary.methods[m];
    const ChartPoint& point = method.points[p];
    table.rows.push_back({cell(point.seconds.median), cell(point.error),
                          std::string(method.method->name), std::to_string(point.spp)});
  }
  return table;
}

ReportTable points(const ChartSummary& summary) {
  ReportTable table{"All measurements: median (least to largest) over the seeds",
                    {"method", "spp", "seconds", "relMSE as measured",
                     "relMSE less the reference's noise", "SMAPE", "non-finite samples"},
                    {}};
  for (const MethodSummary& m : summary.methods)
    for (const ChartPoint& p : m.points)
      table.rows.push_back({std::string(m.method->name), std::to_string(p.spp), cell(p.seconds),
                            cell(p.relmse), summary.floor ? cell(p.relmse_corrected) : "-",
                            cell(p.smape), std::to_string(p.non_finite)});
  return table;
}

std::vector<ReportTable> chart_tables(const ChartSummary& summary) {
  return {level_table("relMSE at equal time; -: not measured there, nothing is extrapolated",
                      "seconds", summary, summary.equal_time),
          level_table("Seconds to an error; -: not reached, or below it from the first point on",
                      "relMSE", summary, summary.equal_error),
          fits(summary), pareto_front(summary), points(summary)};
}

}  // namespace

Report chart_report(const ChartSettings& settings, const ChartSummary& summary, const RunLog& log,
                    const GroundTruth& truth, bool has_charts,
                    std::vector<std::pair<std::string, std::string>> facts) {
  Report report;
  report.title = "Error against time: " + chart_title(settings);
  report.notes = notes(summary);
  report.pictures = pictures(summary, log, truth);
  if (has_charts)
    report.charts = {
        {"Error against render time: median and min-max band over the seeds",
         read_file(settings.folder + "/error_vs_time.svg")},
        {"Error against samples per pixel", read_file(settings.folder + "/error_vs_spp.svg")}};
  report.tables = chart_tables(summary);
  report.facts = std::move(facts);
  report.facts.emplace_back("number of seeds", std::to_string(settings.seeds));
  report.facts.emplace_back("noise of the reference", truth.reference.variance_source);
  if (const auto count = truth.reference.non_finite_samples)
    report.facts.emplace_back("non-finite samples of the reference", std::to_string(*count));
  return report;
}

}  // namespace raytracing
