#include "stress_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "raytracing/study/stress_plot.h"

namespace raytracing {

std::vector<const StressCell*> StressTable::with(std::size_t method, Verdict verdict) const {
  std::vector<const StressCell*> result;
  for (std::size_t s = 0; s < settings(); ++s)
    if (at(s, method).verdict == verdict) result.push_back(&at(s, method));
  return result;
}

Verdict StressTable::worst(std::size_t method) const {
  Verdict result = Verdict::holds;
  for (std::size_t s = 0; s < settings(); ++s) result = std::max(result, at(s, method).verdict);
  return result;
}

std::vector<StressTable> stress_tables(const StressResult& result) {
  std::vector<StressTable> tables;
  for (const StressCell& cell : result.cells) {
    if (tables.empty() || tables.back().stress_case != cell.stress_case)
      tables.push_back({cell.stress_case, {}, {}});
    StressTable& table = tables.back();
    if (std::find(table.methods.begin(), table.methods.end(), cell.method) == table.methods.end())
      table.methods.push_back(cell.method);
    table.cells.push_back(&cell);
  }
  return tables;
}

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

}  // namespace raytracing
