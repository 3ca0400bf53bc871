#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/study/stress/cases.h"
#include "raytracing/study/stress/truth.h"

namespace raytracing {

inline constexpr int kStressSpp = 64;  ///< samples of a pixel, unless paths are shared

enum class Verdict { holds, noisy, biased, broken };
std::string_view to_string(Verdict verdict);

/// The measurement of one method at one setting of one case: means of pixels of `samples` samples
/// with independent scrambles. All but `nanoseconds` is the same in every run.
struct StressCell {
  const StressCase* stress_case;
  const StressSetting* setting;
  const DirectMethod* method;
  StressTruth truth;
  std::uint64_t pixels = 0;
  int samples = 0;  ///< of each pixel, or of the pictures whose pixels share paths
  double mean = 0;
  double standard_error = 0;  ///< of the mean
  double skewness = 0;        ///< of the pixels
  double rmse = 0;            ///< of a pixel against the truth
  double largest_sample = 0;
  double largest_share = 0;      ///< of one sample in the sum of all; 0 where all are 0
  double dark_pixels = 0;        ///< share of pixels whose samples all are 0
  std::uint64_t not_finite = 0;  ///< samples that are not finite or below 0; counted as 0
  double nanoseconds = 0;        ///< processor time of a sample
  bool repeated = false;         ///< measured again, because the first measurement looked biased
  Verdict verdict = Verdict::holds;

  /// The value over the exact radiance; the value itself where that is 0.
  double relative(double value) const;
  double relative_bias() const { return relative(mean - truth.radiance); }
  double relative_rmse() const { return relative(rmse); }
  /// Student's t of the bias beyond what rounding explains, with Johnson's correction for skewed
  /// distributions (1978); 0 where rounding explains all.
  double z() const;
  /// Whether z is meaningful: enough samples have met the light that the mean consists of. See
  /// stress_rule().
  bool resolved() const;
};

struct StressResult {
  std::vector<StressCell> cells;  ///< by case, setting, method
  double critical_z = 0;          ///< |z| above it is called a bias; see stress_rule()
  bool complete = false;          ///< false when stopped: then there are no cells

  /// The cells that fail the run: broken ones, and biased ones of methods that claim no bias.
  std::vector<const StressCell*> failures() const;
};

/// The rule of the verdicts as text.
std::string stress_rule(double critical_z);

/// Whether the bias is beyond noise and rounding.
bool looks_biased(const StressCell& cell, double critical_z);

/// The verdict on a complete measurement.
Verdict verdict_on(const StressCell& cell, double critical_z);

/// The critical |z| of so many tests: in all of them together an unbiased method is called biased
/// with a probability of at most 1 % (Bonferroni). Each test has this many pixels.
double critical_z(std::size_t tests, std::uint64_t pixels);

/// The cells of one case, setting by setting.
struct StressTable {
  const StressCase* stress_case;
  std::vector<const DirectMethod*> methods;
  std::vector<const StressCell*> cells;  ///< by setting, then by method

  std::size_t settings() const { return cells.size() / methods.size(); }
  const StressCell& at(std::size_t setting, std::size_t method) const {
    return *cells[setting * methods.size() + method];
  }
  /// The settings at which the method got this verdict.
  std::vector<const StressCell*> with(std::size_t method, Verdict verdict) const;
  /// The worst verdict of the method.
  Verdict worst(std::size_t method) const;
};

std::vector<StressTable> stress_tables(const StressResult& result);

/// The labels of the settings of these cells: "10, 100".
std::string setting_labels(const std::vector<const StressCell*>& cells);

/// What is wrong and where: one line for each method and verdict worse than `holds`.
std::vector<std::string> stress_verdicts(const StressResult& result);

/// All cells as a table for other programs: comma-separated, one line a cell.
std::string stress_csv(const StressResult& result);

}  // namespace raytracing
