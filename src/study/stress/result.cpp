#include "raytracing/study/stress/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "raytracing/study/metrics/statistics.h"

namespace raytracing {
namespace {

constexpr double kFamilyLevel = 0.01;   // probability of a false alarm in a run
constexpr double kRounding = 1e-4;      // relative: of the methods' arithmetic in float32
constexpr double kNoisy = 0.1;          // relative RMSE
constexpr double kLargestShare = 0.01;  // of one sample in the sum
// An event with this expected count is missed with a probability of exp(-12).
constexpr double kMinHits = 12;
constexpr double kDarkPixels = 0.01;

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::noisy:
      return "noisy";
    case Verdict::biased:
      return "biased";
    case Verdict::broken:
      break;
  }
  return "broken";
}

double StressCell::relative(double value) const {
  return truth.radiance > 0 ? value / truth.radiance : value;
}

double StressCell::z() const {
  const double allowed = truth.rounding + kRounding * truth.radiance;
  const double bias = mean - truth.radiance;
  const double beyond = std::copysign(std::max(0.0, std::abs(bias) - allowed), bias);
  if (beyond == 0) return 0;
  if (standard_error == 0) return std::copysign(INFINITY, beyond);
  const double t = beyond / standard_error;
  return t + skewness / (6 * std::sqrt(static_cast<double>(pixels))) * (1 + 2 * t * t);
}

bool StressCell::resolved() const {
  // In half of the pixels a method may find the visible part of the light by chance alone.
  const double hits = 0.5 * truth.visible_share * static_cast<double>(pixels) * samples;
  if (dark_pixels > kDarkPixels && hits < kMinHits) return false;
  return largest_share < kLargestShare;
}

std::vector<const StressCell*> StressResult::failures() const {
  std::vector<const StressCell*> result;
  for (const StressCell& cell : cells)
    if (cell.verdict == Verdict::broken ||
        (cell.verdict == Verdict::biased && cell.method->unbiased))
      result.push_back(&cell);
  return result;
}

std::string stress_rule(double critical_z) {
  return fmt::format(
      "broken: a sample is not finite or below 0. biased: |z| > {:.2f} in two independent "
      "measurements, where z is the bias beyond rounding over its standard error, corrected for "
      "skewness. Rounding: {:g} of the truth, and the change of the truth when shadow rays begin "
      "off the surface, as they do, and occluders move by {} float roundings. No bias is reported "
      "where one sample holds {:g} % of the sum or more, or where pixels are dark and the visible "
      "part of the lights is too small for a uniform point to hit it {:g} times: the mean then "
      "depends on light that no sample has met. Unbiased methods are called biased in at most one "
      "of {:g} runs (Bonferroni). noisy: relative RMSE of {} samples above {:g}, or of more "
      "samples "
      "where pixels share paths. holds: none of these.",
      critical_z, kRounding, kOccluderRoundings, 100 * kLargestShare, 2 * kMinHits,
      1 / kFamilyLevel, kStressSpp, kNoisy);
}

bool looks_biased(const StressCell& cell, double critical_z) {
  return cell.resolved() && std::abs(cell.z()) > critical_z;
}

Verdict verdict_on(const StressCell& cell, double critical_z) {
  if (cell.not_finite > 0) return Verdict::broken;
  if (looks_biased(cell, critical_z)) return Verdict::biased;
  return cell.relative_rmse() > kNoisy ? Verdict::noisy : Verdict::holds;
}

double critical_z(std::size_t tests, std::uint64_t pixels) {
  return student_t_quantile(1 - kFamilyLevel / static_cast<double>(std::max<std::size_t>(tests, 1)),
                            static_cast<int>(pixels) - 1);
}

std::string setting_labels(const std::vector<const StressCell*>& cells) {
  std::string text;
  for (const StressCell* cell : cells) text += (text.empty() ? "" : ", ") + cell->setting->label;
  return text;
}

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

std::vector<std::string> stress_verdicts(const StressResult& result) {
  const std::vector<StressTable> tables = stress_tables(result);
  std::vector<std::string> lines;
  for (std::size_t m = 0; m < tables[0].methods.size(); ++m)
    for (const Verdict verdict : {Verdict::broken, Verdict::biased, Verdict::noisy}) {
      std::string text;
      for (const StressTable& table : tables) {
        const auto cells = table.with(m, verdict);
        if (!cells.empty())
          text += fmt::format("{}{} at {}", text.empty() ? "" : "; ", table.stress_case->name,
                              setting_labels(cells));
      }
      if (!text.empty())
        lines.push_back(
            fmt::format("{}: {}: {}", tables[0].methods[m]->name, to_string(verdict), text));
    }
  return lines;
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
