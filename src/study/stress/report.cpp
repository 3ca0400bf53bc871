#include "raytracing/study/stress/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "embedded/stress_script.h"
#include "raytracing/io/file.h"
#include "raytracing/study/page/result_folder.h"

namespace raytracing {
namespace {

// The text in a cell: none where the method holds, capitals where it is wrong and not only noisy.
std::string cell_text(Verdict verdict) {
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

struct CellPlace {
  std::size_t column, row;
  std::string_view column_label;
  std::string row_label;
};

std::string line(const CellPlace& place, double rmse, const std::string& text) {
  return fmt::format("{} {} {:.4g} \"{}\" \"{}\" \"{}\"\n", place.column, place.row, rmse, text,
                     place.column_label, place.row_label);
}

// One row for each method, one column for each setting.
std::string case_block(const StressTable& table) {
  std::string text = fmt::format("# {}\n", table.stress_case->name);
  for (std::size_t s = 0; s < table.settings(); ++s)
    for (std::size_t m = 0; m < table.methods.size(); ++m) {
      const StressCell& cell = table.at(s, m);
      text += line({s, m, cell.setting->label, method_label(*cell.method)}, cell.relative_rmse(),
                   cell_text(cell.verdict));
    }
  return text + "\n\n";
}

// One row for each case, one column for each method: the worst setting.
std::string overview_block(const std::vector<StressTable>& tables) {
  std::string text = "# overview\n";
  for (std::size_t t = 0; t < tables.size(); ++t)
    for (std::size_t m = 0; m < tables[t].methods.size(); ++m) {
      const StressTable& table = tables[t];
      double rmse = 0;
      for (std::size_t s = 0; s < table.settings(); ++s)
        rmse = std::max(rmse, table.at(s, m).relative_rmse());
      const Verdict worst = table.worst(m);
      const std::string where = worst == Verdict::holds
                                    ? ""
                                    : fmt::format("{} {}/{}", cell_text(worst),
                                                  table.with(m, worst).size(), table.settings());
      text +=
          line({m, t, table.methods[m]->name, std::string(table.stress_case->name)}, rmse, where);
    }
  return text;
}

// Adds the picture of the case's family, once: cases of a family follow one another.
void add_family(const StressCase& c, std::vector<std::string>& names) {
  std::string name = fmt::format("stress_{}", c.family);
  if (names.back() != name) names.push_back(std::move(name));
}

ReportTable verdict_table(const std::vector<StressTable>& tables) {
  ReportTable result{"Worst verdict of each case, with the settings that got it", {"case"}, {}};
  for (const DirectMethod* method : tables[0].methods) result.header.emplace_back(method->name);
  for (const StressTable& table : tables) {
    std::vector<std::string> row{std::string(table.stress_case->name)};
    for (std::size_t m = 0; m < table.methods.size(); ++m) {
      const Verdict worst = table.worst(m);
      std::string text(to_string(worst));
      if (worst != Verdict::holds) text += ": " + setting_labels(table.with(m, worst));
      row.push_back(std::move(text));
    }
    result.rows.push_back(std::move(row));
  }
  return result;
}

ReportTable case_table(const StressTable& table) {
  ReportTable result{fmt::format("{}: {}. Truth: {}.", table.stress_case->name,
                                 table.stress_case->parameter, table.stress_case->truth),
                     {"setting", "method", "truth", "bias", "± standard error", "z",
                      fmt::format("RMSE, N = {}", table.cells[0]->samples),
                      "largest sample / truth", "not finite", "ns / sample", "verdict"},
                     {}};
  for (const StressCell* c : table.cells)
    result.rows.push_back(
        {c->setting->label, std::string(c->method->name), fmt::format("{:.6g}", c->truth.radiance),
         fmt::format("{:+.3g} %", 100 * c->relative_bias()),
         fmt::format("{:.2g} %", 100 * c->relative(c->standard_error)),
         c->resolved() ? fmt::format("{:.1f}", c->z()) : "-",
         fmt::format("{:.3g}", c->relative_rmse()),
         fmt::format("{:.3g}", c->relative(c->largest_sample)), std::to_string(c->not_finite),
         fmt::format("{:.0f}", c->nanoseconds), std::string(to_string(c->verdict))});
  return result;
}

}  // namespace

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
  std::string text = "# column row RMSE/truth verdict column-label row-label\n";
  for (const StressTable& table : tables) text += case_block(table);
  return text + overview_block(tables);
}

std::string stress_plot_script(const StressResult& result) {
  const std::vector<StressTable> tables = stress_tables(result);
  std::vector<std::string> titles;
  std::vector<std::size_t> columns, rows, samples, first, last;
  for (const StressTable& table : tables) {
    titles.push_back(fmt::format("{}: {}", table.stress_case->name, table.stress_case->parameter));
    columns.push_back(table.settings());
    rows.push_back(table.methods.size());
    samples.push_back(static_cast<std::size_t>(table.cells[0]->samples));
  }
  titles.emplace_back("each case at its worst setting; in how many settings of how many");
  columns.push_back(tables[0].methods.size());
  rows.push_back(tables.size());
  const bool all_equal = std::equal(samples.begin() + 1, samples.end(), samples.begin());
  samples.push_back(all_equal ? samples[0] : 0);
  first.push_back(titles.size());
  last.push_back(titles.size());
  for (std::size_t t = 0; t < tables.size(); ++t) {
    const bool begins =
        t == 0 || tables[t].stress_case->family != tables[t - 1].stress_case->family;
    if (begins) first.push_back(t + 1), last.push_back(t + 1);
    last.back() = t + 1;
  }
  const auto numbers = [](const char* name, const std::vector<std::size_t>& values) {
    return fmt::format("array {}[{}] = [{}]\n", name, values.size(), fmt::join(values, ", "));
  };
  std::string text =
      "# Draws the heat maps. Run gnuplot 5.2 or later on it in this folder:\n"
      "#   gnuplot stress.gp\n";
  text +=
      "# The panels, in the order of the blocks of stress.dat; the last one is the overview. "
      "samples: N of\n# the RMSE; 0: it differs.\n";
  text += gnuplot_array("title", titles) + numbers("columns", columns) + numbers("rows", rows);
  text += numbers("samples", samples);
  text += "# The pictures, and the first and last panel of each.\n";
  text += gnuplot_array("picture", stress_pictures(result)) + numbers("first", first);
  text += numbers("last", last) + "\n";
  return text.append(kStressScript);
}

Report stress_report(const StressResult& result, const std::string& folder, bool has_pictures,
                     std::vector<std::pair<std::string, std::string>> facts) {
  const std::vector<StressTable> tables = stress_tables(result);
  Report report;
  report.title = "Stress: where the methods fail";
  report.notes.emplace_back(
      "Each case sweeps one parameter towards trouble, at one point of a surface whose exact "
      "direct light is known without the renderer.");
  for (const std::string& line : stress_verdicts(result)) report.notes.push_back(line + ".");
  report.notes.push_back(stress_rule(result.critical_z));
  if (has_pictures)
    for (const std::string& name : stress_pictures(result))
      report.charts.push_back({name == "stress" ? "All cases" : "Cases of the " + name.substr(7),
                               read_file(folder + "/" + name + ".svg")});
  report.tables.push_back(verdict_table(tables));
  for (const StressTable& table : tables) report.tables.push_back(case_table(table));
  report.facts = std::move(facts);
  return report;
}

}  // namespace raytracing
