#include "raytracing/study/chart_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raytracing {
namespace {

// Okabe and Ito's colours, told apart by the colour-blind; those of the studies. With marks that
// differ without colour.
struct Look {
  const char* colour;
  int mark;
};
constexpr std::array kLooks{Look{"#e69f00", 7}, Look{"#d55e00", 5},  Look{"#cc79a7", 8},
                            Look{"#56b4e9", 13}, Look{"#000000", 9}, Look{"#009e73", 11}};

// A method looks the same in all charts.
Look look_of(const DirectMethod& method) {
  const auto index = static_cast<std::size_t>(&method - direct_methods().data());
  return kLooks[index % kLooks.size()];
}

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

// Straight lines of known slopes, through a corner above the highest curve.
std::string slope_guides(const ChartSummary& summary, bool over_time) {
  double x = std::numeric_limits<double>::infinity(), y = 0;
  for (const MethodSummary& m : summary.methods)
    for (const ChartPoint& p : m.points) {
      x = std::min(x, over_time ? p.seconds.low : static_cast<double>(p.spp));
      y = std::max(y, errors_of(summary, p).high);
    }
  std::string text;
  for (const auto& [slope, dash] : {std::pair{"-1", 2}, std::pair{"-1.5", 4}})
    text += fmt::format(", \\\n  {:.6g}*(x/{:.6g})**({}) with lines lw 1 dt {} lc rgb '#888888' "
                        "title 'slope {}'", 1.5 * y, x, slope, dash, slope);
  return text;
}

std::string plot_command(const ChartSummary& summary, bool over_time) {
  const int x = over_time ? 2 : 1;
  std::string text = "plot \\\n  ";
  if (summary.floor && summary.floor->relmse.value > 0)
    text += fmt::format("{:.6g} with filledcurves y1=bottom fc rgb '#dddddd' fs solid 1 noborder "
                        "title 'noise of the reference (subtracted)', \\\n  ",
                        summary.floor->relmse.value);
  for (std::size_t i = 0; i < summary.methods.size(); ++i)
    text += fmt::format("'chart.dat' index {} using {}:6:7 with filledcurves fc rgb '{}' "
                        "fs transparent solid 0.18 noborder notitle, \\\n  ",
                        i, x, look_of(*summary.methods[i].method).colour);
  for (std::size_t i = 0; i < summary.methods.size(); ++i) {
    const DirectMethod& method = *summary.methods[i].method;
    const Look look = look_of(method);
    text += fmt::format("{}'chart.dat' index {} using {}:5 with linespoints lw 2 ps 1.1 pt {} "
                        "lc rgb '{}' title '{}{}'", i == 0 ? "" : ", \\\n  ", i, x, look.mark,
                        look.colour, method.name, method.unbiased ? "" : " (biased)");
  }
  return text + slope_guides(summary, over_time) + "\n";
}

constexpr const char* kScriptHead = R"(# Draws the charts. Run gnuplot 5 on it in this folder:
#   gnuplot chart.gp
set logscale xy
set format y '10^{{%L}}'
set grid lc rgb '#dddddd'
set border lc rgb '#444444'
set key outside right top Left reverse samplen 2 noenhanced
set title {} noenhanced
set ylabel 'error: relMSE = mean of (x-r)^2 / (r^2 + 0.01){}'
bottom = {:.6g}
set yrange [bottom:*]
)";

// On white, also where the page around is dark.
constexpr const char* kTerminals[][2] = {
    {"svg", "set terminal svg size 960,560 font 'sans,14' background rgb 'white'"},
    {"png", "set terminal pngcairo size 1440,840 font 'sans,18' linewidth 1.5 background rgb "
            "'white'"}};

}  // namespace

double plot_bottom(const ChartSummary& summary) {
  double low = std::numeric_limits<double>::infinity();
  const auto consider = [&low](double value) {
    if (value > 0) low = std::min(low, value);
  };
  if (summary.floor) consider(summary.floor->relmse.value);
  for (const MethodSummary& m : summary.methods)
    for (const ChartPoint& p : m.points)
      if (p.measurable) consider(p.error);
  return std::isinf(low) ? 1e-9 : std::pow(10, std::floor(std::log10(0.7 * low)));
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
      fmt::format(fmt::runtime(kScriptHead), quoted(title),
                  summary.floor ? ", less noise of the reference" : "", plot_bottom(summary));
  for (const bool over_time : {true, false}) {
    text += over_time ? "\nset xlabel 'render time of one picture, seconds (wall clock)'\n"
                        "set format x '%g'\n"
                      : "\nset xlabel 'samples per pixel'\nset logscale x 2\nset format x '%g'\n";
    for (const auto& [extension, terminal] : kTerminals)
      text += fmt::format("{}\nset output 'error_vs_{}.{}'\n{}unset output\n", terminal,
                          over_time ? "time" : "spp", extension,
                          plot_command(summary, over_time));
  }
  return text;
}

}  // namespace raytracing
