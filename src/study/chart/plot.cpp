#include "raytracing/study/chart/plot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "embedded/chart_script.h"
#include "raytracing/study/metrics/error_metrics.h"
#include "raytracing/study/page/report_page.h"
#include "raytracing/study/page/result_folder.h"

namespace raytracing {
namespace {

const Spread& errors_of(const ChartSummary& summary, const ChartPoint& point) {
  return summary.floor ? point.relmse_corrected : point.relmse;
}

std::string positive(double value) { return value > 0 ? fmt::format("{:.6g}", value) : "NaN"; }

// The script reads the places of tics from text, where gnuplot 5.4 refuses 5e-05.
std::string without_exponent(double value) {
  std::string text = fmt::format("{:.12f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// The smallest and the largest value(point) of all points.
template <class Value>
Range range_of(const ChartSummary& summary, const Value& value) {
  Range range;
  for (const MethodSummary& m : summary.methods)
    for (const ChartPoint& p : m.points) range.add(value(p));
  return range;
}

}  // namespace

double plot_bottom(const ChartSummary& summary) {
  double low = std::numeric_limits<double>::infinity();
  for (const MethodSummary& m : summary.methods)
    for (const ChartPoint& p : m.points)
      if (p.measurable) low = std::min(low, p.error);
  if (std::isinf(low)) return 1e-9;
  constexpr double kFarBelow = 30;  // a floor lower than that would only flatten the curves
  if (summary.floor && summary.floor->relmse.value > low / kFarBelow)
    low = std::min(low, summary.floor->relmse.value);
  return std::pow(10, std::floor(std::log10(0.7 * low)));
}

std::string plot_data(const ChartSummary& summary, double bottom) {
  std::string text = fmt::format(
      "# error: relMSE{}; NaN: not above 0; {:.6g} as the least error: not above 0\n"
      "# spp seconds(median min max) error(median min max)\n",
      summary.floor ? " less the noise floor" : "", bottom);
  for (const MethodSummary& m : summary.methods) {
    text += fmt::format("# {}\n", m.method->name);
    for (const ChartPoint& p : m.points) {
      const Spread& e = errors_of(summary, p);
      text += fmt::format("{} {:.6g} {:.6g} {:.6g} {} {} {}\n", p.spp, p.seconds.median,
                          p.seconds.low, p.seconds.high, positive(e.median),
                          e.low > 0 ? positive(e.low) : fmt::format("{:.6g}", bottom),
                          positive(e.high));
    }
    text += "\n\n";
  }
  return text;
}

std::string plot_script(const ChartSummary& summary, const std::string& title) {
  std::vector<std::string> labels, colours, marks, tics(2);
  for (const MethodSummary& m : summary.methods) {
    labels.push_back(method_label(*m.method));
    colours.emplace_back(m.method->colour);
    marks.push_back(std::to_string(m.method->mark));
  }
  const auto spp =
      range_of(summary, [](const ChartPoint& p) { return static_cast<double>(p.spp); });
  const auto seconds = range_of(summary, [](const ChartPoint& p) { return p.seconds.median; });
  for (const ChartPoint& p : summary.methods[0].points) tics[0] += std::to_string(p.spp) + " ";
  for (const double tic : round_numbers(seconds.low, seconds.high))
    tics[1] += without_exponent(tic) + " ";
  const std::string subtitle =
      fmt::format("median and min-max band of {} seeds{}", summary.methods[0].points[0].seeds,
                  summary.floor ? ", less the noise of the reference" : "");
  std::string text =
      "# Draws the charts. Run gnuplot 5.2 or later on it in this folder:\n#   gnuplot chart.gp\n";
  text +=
      fmt::format("title = {}\nsubtitle = {}\n", gnuplot_string(title), gnuplot_string(subtitle));
  text += fmt::format("epsilon = {:g}  # of relMSE\n", kRelMseEpsilon);
  text += fmt::format("noise = {:.6g}  # relMSE of the reference itself; 0: not known\n",
                      summary.floor ? summary.floor->relmse.value : 0);
  text += fmt::format("bottom = {:.6g}  # of the error axis\n", plot_bottom(summary));
  text += fmt::format("top = {:.6g}  # the largest error\n", range_of(summary, [&](const auto& p) {
                                                               return errors_of(summary, p).high;
                                                             }).high);
  text += "# By samples per pixel and by seconds: the smallest value, the largest, and labels.\n";
  text += fmt::format("array low[2] = [{:.6g}, {:.6g}]\n", spp.low, seconds.low);
  text += fmt::format("array high[2] = [{:.6g}, {:.6g}]\n", spp.high, seconds.high);
  text += gnuplot_array("tics", tics);
  text += "# The methods, in the order of chart.dat.\n";
  text += gnuplot_array("label", labels) + gnuplot_array("colour", colours);
  text += gnuplot_array("mark", marks) + "\n";
  return text.append(kChartScript);
}

}  // namespace raytracing
