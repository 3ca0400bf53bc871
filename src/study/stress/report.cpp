#include "raytracing/study/stress/report.h"

#include <fmt/format.h>

#include "raytracing/io/file.h"
#include "raytracing/study/stress/plot.h"

namespace raytracing {
namespace {

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
                     {"setting", "method", "truth", "bias", "± standard error", "z", "RMSE, N = 64",
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

Report stress_report(const StressResult& result, const std::string& folder, bool has_pictures,
                     std::vector<std::pair<std::string, std::string>> facts) {
  const std::vector<StressTable> tables = stress_tables(result);
  Report report;
  report.title = "Stress: where the methods fail";
  report.notes.push_back(
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
