#include "raytracing/study/chart_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace raytracing {
namespace {

// As gnuplot takes it between single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

const Spread& errors_of(const ChartSummary& summary, const ChartPoint& point) {
  return summary.floor ? point.relmse_corrected : point.relmse;
}

std::string positive(double value) { return value > 0 ? fmt::format("{:.6g}", value) : "NaN"; }

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Range x_range(const ChartSummary& summary, bool over_time) {
  Range range;
  for (const MethodSummary& m : summary.methods)
    for (const ChartPoint& p : m.points)
      range.add(over_time ? p.seconds.median : static_cast<double>(p.spp));
  return range;
}

// Straight lines of known slopes, through a corner above the highest curve.
std::string slope_guides(const ChartSummary& summary, bool over_time) {
  Range y;
  for (const MethodSummary& m : summary.methods)
    for (const ChartPoint& p : m.points) y.add(errors_of(summary, p).high);
  std::string text;
  for (const auto& [slope, dash] : {std::pair{"-1", 2}, std::pair{"-1.5", 4}})
    text += fmt::format(
        ", \\\n  {:.6g}*(x/{:.6g})**({}) with lines lw 1 dt {} lc rgb '#777777' "
        "title 'slope {}'",
        1.5 * y.high, x_range(summary, over_time).low, slope, dash, slope);
  return text;
}

// Labels where people look for them, also within less than a decade.
std::string tics(const ChartSummary& summary, bool over_time) {
  std::vector<double> values;
  if (over_time) {
    const Range range = x_range(summary, over_time);
    values = round_numbers(range.low, range.high);
  } else {
    for (const ChartPoint& p : summary.methods[0].points)
      values.push_back(static_cast<double>(p.spp));
  }
  if (values.empty()) return "auto";
  return fmt::format("({:g})", fmt::join(values, ", "));
}

std::string plot_command(const ChartSummary& summary, bool over_time) {
  const int x = over_time ? 2 : 1;
  std::string text = "plot \\\n  ";
  if (summary.floor && summary.floor->relmse.value > 0)
    text += fmt::format(
        "{:.6g} with filledcurves y1=bottom fc rgb '#999999' fs pattern 4 noborder "
        "title 'noise of the reference, {:.2g}', \\\n  ",
        std::max(summary.floor->relmse.value, plot_bottom(summary)), summary.floor->relmse.value);
  for (std::size_t i = 0; i < summary.methods.size(); ++i)
    text += fmt::format(
        "'chart.dat' index {} using {}:6:7 with filledcurves fc rgb '{}' "
        "fs transparent solid 0.14 noborder notitle, \\\n  ",
        i, x, summary.methods[i].method->colour);
  for (std::size_t i = 0; i < summary.methods.size(); ++i) {
    const DirectMethod& method = *summary.methods[i].method;
    text += fmt::format(
        "{}'chart.dat' index {} using {}:5 with linespoints lw 2 ps 1.1 pt {} "
        "lc rgb '{}' title '{}{}'",
        i == 0 ? "" : ", \\\n  ", i, x, method.mark, method.colour, method.name,
        method.unbiased ? "" : " (biased)");
  }
  return text + slope_guides(summary, over_time) + "\n";
}

constexpr const char* kScriptHead = R"(# Draws the charts. Run gnuplot 5 on it in this folder:
#   gnuplot chart.gp
set logscale xy
set format y '10^{{%L}}'
set grid lt 1 lw 0.7 lc rgb '#d8d8d8'
set border lc rgb '#444444'
set key at screen 0.5,0.015 center bottom horizontal maxrows 4 Left reverse samplen 2.5 noenhanced
set bmargin 8.5
set title {} . "\n" . 'median and min-max band of {} seeds{}' noenhanced
set ylabel 'relMSE = mean of (x-r)^2 / (r^2 + 0.01)'
bottom = {:.6g}
set yrange [bottom:*]
)";

// On white, also where the page around is dark.
constexpr const char* kTerminals[][2] = {
    {"svg", "set terminal svg size 960,640 font 'sans,14' background rgb 'white'"},
    {"png",
     "set terminal pngcairo size 1440,960 font 'sans,19' linewidth 1.5 background rgb "
     "'white'"}};

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
  std::string text =
      fmt::format(fmt::runtime(kScriptHead), quoted(title), summary.methods[0].points[0].seeds,
                  summary.floor ? ", less the noise of the reference" : "", plot_bottom(summary));
  for (const bool over_time : {true, false}) {
    const Range x = x_range(summary, over_time);
    text += fmt::format(
        "\nset xlabel '{}'\nset xtics {}\n",
        over_time ? "render time of one picture, seconds (wall clock)" : "samples per pixel",
        tics(summary, over_time));
    text += fmt::format("set xrange [{:.6g}:{:.6g}]\n", x.low / 1.1, 1.1 * x.high);
    for (const auto& [extension, terminal] : kTerminals)
      text += fmt::format("{}\nset output 'error_vs_{}.{}'\n{}unset output\n", terminal,
                          over_time ? "time" : "spp", extension, plot_command(summary, over_time));
  }
  return text;
}

}  // namespace raytracing
