#include "chart_tables.h"

#include <fmt/format.h>

namespace raytracing {
namespace {

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

std::vector<std::string> with_methods(const std::string& first, const ChartSummary& summary) {
  std::vector<std::string> header{first};
  for (const MethodSummary& m : summary.methods) header.emplace_back(m.method->name);
  return header;
}

ReportTable equal_time(const ChartSummary& summary) {
  ReportTable table{"relMSE at equal time; -: not measured there, nothing is extrapolated",
                    with_methods("seconds", summary),
                    {}};
  for (const double seconds : summary.times) {
    auto& row = table.rows.emplace_back(1, fmt::format("{:.3g}", seconds));
    for (const MethodSummary& m : summary.methods) row.push_back(cell(error_at(m.curve, seconds)));
  }
  return table;
}

ReportTable equal_error(const ChartSummary& summary) {
  ReportTable table{"Seconds to an error; -: not reached, or below it from the first point on",
                    with_methods("relMSE", summary),
                    {}};
  for (const double error : summary.errors) {
    auto& row = table.rows.emplace_back(1, fmt::format("{:.3g}", error));
    for (const MethodSummary& m : summary.methods) row.push_back(cell(time_to(m.curve, error)));
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
                     "mean less the reference's, %", "told from 0"},
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

}  // namespace

std::vector<ReportTable> chart_tables(const ChartSummary& summary) {
  return {equal_time(summary), equal_error(summary), fits(summary), pareto_front(summary),
          points(summary)};
}

}  // namespace raytracing
