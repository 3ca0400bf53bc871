#include "raytracing/study/stress_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "stress_table.h"

namespace raytracing {
namespace {

// The colours' range, log10 of the relative RMSE.
constexpr double kLow = -4, kHigh = 0.5;

double colour(double rmse) { return rmse > 0 ? std::clamp(std::log10(rmse), kLow, kHigh) : kLow; }

// Nothing where the method holds; capitals for what is wrong, not only noisy.
std::string mark(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "";
    case Verdict::noisy:
      return "noisy";
    case Verdict::biased:
      return "BIASED";
    case Verdict::broken:
      break;
  }
  return "BROKEN";
}

// Short: one digit, and no exponent where it is not needed.
std::string number(double rmse) {
  return rmse < 9.5 ? fmt::format("{:.1g}", rmse) : fmt::format("{:.0f}", rmse);
}

// x, y, colour, two lines of text.
std::string row(std::size_t x, std::size_t y, double rmse, const std::string& mark) {
  return fmt::format("{} {} {:.4f} \"{}\" \"{}\"\n", x, y, colour(rmse), number(rmse), mark);
}

std::string case_block(const StressTable& table) {
  std::string text = fmt::format("# {}\n", table.stress_case->name);
  for (std::size_t s = 0; s < table.settings(); ++s)
    for (std::size_t m = 0; m < table.methods.size(); ++m)
      text += row(s, m, table.at(s, m).relative_rmse(), mark(table.at(s, m).verdict));
  return text + "\n\n";
}

// Each case's worst setting.
std::string overview_block(const std::vector<StressTable>& tables) {
  std::string text = "# overview\n";
  for (std::size_t t = 0; t < tables.size(); ++t)
    for (std::size_t m = 0; m < tables[t].methods.size(); ++m) {
      double rmse = 0;
      for (std::size_t s = 0; s < tables[t].settings(); ++s)
        rmse = std::max(rmse, tables[t].at(s, m).relative_rmse());
      const Verdict worst = tables[t].worst(m);
      const std::string where =
          worst == Verdict::holds
              ? ""
              : fmt::format("{} {}/{}", mark(worst), tables[t].with(m, worst).size(),
                            tables[t].settings());
      text += row(m, t, rmse, where);
    }
  return text;
}

std::string tics(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}'{}' {}", i == 0 ? "" : ", ", names[i], i);
  return text;
}

std::vector<std::string> method_names(const StressTable& table) {
  std::vector<std::string> names;
  for (const DirectMethod* method : table.methods) names.emplace_back(method->name);
  return names;
}

std::vector<std::string> method_labels(const StressTable& table) {
  std::vector<std::string> names = method_names(table);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!table.methods[i]->unbiased) names[i] += " (biased)";
  return names;
}

std::string panel(std::size_t index, const std::vector<std::string>& x,
                  const std::vector<std::string>& y, const std::string& title) {
  return fmt::format(
      "set title \"{}\" noenhanced\n"
      "set xrange [-0.5:{}.5]\nset yrange [{}.5:-0.5]\nset xtics ({})\nset ytics ({})\n"
      "plot 'stress.dat' index {} using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with "
      "boxxyerror fs solid border lc rgb 'white' fc palette notitle, \\\n"
      "  '' index {} using 1:2:4 with labels offset 0,0.4 notitle, \\\n"
      "  '' index {} using 1:2:5 with labels offset 0,-0.6 font ',9' notitle\n",
      title, x.size() - 1, y.size() - 1, tics(x), tics(y), index, index, index);
}

std::string case_panel(std::size_t index, const StressTable& table) {
  std::vector<std::string> labels;
  for (std::size_t s = 0; s < table.settings(); ++s)
    labels.push_back(table.at(s, 0).setting->label);
  return panel(index, labels, method_labels(table),
               fmt::format("{}: {}", table.stress_case->name, table.stress_case->parameter));
}

constexpr const char* kScriptHead = R"(# Draws the heat maps. Run gnuplot 5 on it in this folder:
#   gnuplot stress.gp
set palette defined (-4 '#f2f7fc', -2 '#b9d4ec', -1 '#fee08b', 0 '#f4814f', 0.5 '#d9463a')
set cbrange [-4:0.5]
set format cb '10^{%g}'
set cbtics 1
set cblabel 'RMSE / truth, N = 64'
set lmargin 20
set rmargin 14
set tmargin 2.5
set bmargin 2
set tics nomirror scale 0 noenhanced
set border lc rgb '#888888'
unset key
)";

// Both kinds of file, on white, also where the page around is dark.
std::string draw(const std::string& name, int width, int height, const std::string& commands) {
  std::string text = fmt::format(
      "\nset terminal svg size {},{} font 'sans,12' background rgb "
      "'white'\nset output '{}.svg'\n{}unset output\n",
      width, height, name, commands);
  return text + fmt::format(
                    "set terminal pngcairo size {},{} font 'sans,12' background rgb "
                    "'white'\nset output '{}.png'\n{}unset output\n",
                    width, height, name, commands);
}

// The picture of the case's family, once: cases of a family follow one another.
void add_family(const StressCase& c, std::vector<std::string>& names) {
  std::string name = fmt::format("stress_{}", c.family);
  if (names.back() != name) names.push_back(std::move(name));
}

}  // namespace

std::string stress_csv(const StressResult& result) {
  std::string text =
      "case,setting,method,claims_unbiased,truth,rounding,pixels,mean,relative_bias,"
      "relative_standard_error,z,resolved,repeated,relative_rmse,largest_sample_over_truth,"
      "largest_share,not_finite,nanoseconds_per_sample,verdict\n";
  for (const StressCell& c : result.cells)
    text += fmt::format(
        "{},{},{},{},{:.9g},{:.3g},{},{:.9g},{:.4g},{:.4g},{:.4g},{:d},{:d},{:.4g},{:.4g},{:.4g},"
        "{},{:.4g},{}\n",
        c.stress_case->name, c.setting->label, c.method->name, c.method->unbiased ? 1 : 0,
        c.truth.radiance, c.truth.rounding, c.pixels, c.mean, c.relative_bias(),
        c.relative(c.standard_error), c.z(), c.resolved(), c.repeated, c.relative_rmse(),
        c.relative(c.largest_sample), c.largest_share, c.not_finite, c.nanoseconds,
        to_string(c.verdict));
  return text;
}

std::vector<std::string> stress_pictures(const StressResult& result) {
  std::vector<std::string> names{"stress"};
  for (const StressTable& table : stress_tables(result)) add_family(*table.stress_case, names);
  return names;
}

std::vector<std::string> all_stress_pictures() {
  std::vector<std::string> names{"stress"};
  for (const StressCase& c : stress_cases()) add_family(c, names);
  return names;
}

std::string stress_plot_data(const StressResult& result) {
  const std::vector<StressTable> tables = stress_tables(result);
  std::string text = "# column row log10(relative RMSE, clamped) RMSE mark\n";
  for (const StressTable& table : tables) text += case_block(table);
  return text + overview_block(tables);
}

std::string stress_plot_script(const StressResult& result) {
  const std::vector<StressTable> tables = stress_tables(result);
  std::string text = kScriptHead;
  std::vector<std::string> cases;
  for (const StressTable& table : tables) cases.emplace_back(table.stress_case->name);
  constexpr int kWidth = 1000, kRow = 46, kPanelRest = 90;
  constexpr int kFewestRows = 4;  // for the colours' scale
  const int rows = std::max(static_cast<int>(tables.size()), kFewestRows);
  text += draw("stress", kWidth, kRow * rows + kPanelRest,
               panel(tables.size(), method_names(tables[0]), cases,
                     "each case at its worst setting; in how many settings of how many"));
  for (std::size_t first = 0; first < tables.size();) {
    const std::string_view family = tables[first].stress_case->family;
    std::size_t end = first;
    std::string commands;
    for (; end < tables.size() && tables[end].stress_case->family == family; ++end)
      commands += case_panel(end, tables[end]);
    const int panels = static_cast<int>(end - first);
    const int height = kRow * static_cast<int>(tables[first].methods.size()) + kPanelRest;
    text += draw(fmt::format("stress_{}", family), kWidth, panels * height,
                 fmt::format("set multiplot layout {},1\n{}unset multiplot\n", panels, commands));
    first = end;
  }
  return text;
}

}  // namespace raytracing
