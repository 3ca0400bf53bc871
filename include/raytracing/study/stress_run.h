#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/study/stress_case.h"
#include "raytracing/study/stress_truth.h"

namespace raytracing {

/// What is measured how thoroughly.
struct StressPlan {
  std::vector<const StressCase*> cases;
  std::vector<const DirectMethod*> methods;
  std::uint64_t seeds = 4;  ///< kPixelsPerSeed pixels each
  int line_rays = 4;
  int threads = 1;
};

inline constexpr int kStressSpp = 64;  ///< samples of a pixel
inline constexpr int kPixelsPerSeed = 256;

enum class Verdict { holds, noisy, biased, broken };
std::string_view to_string(Verdict verdict);

/// One method at one setting of one case: the means of pixels of kStressSpp samples, whose
/// scramblings are independent. All but `nanoseconds` is the same for every run.
struct StressCell {
  const StressCase* stress_case;
  const StressSetting* setting;
  const DirectMethod* method;
  StressTruth truth;
  std::uint64_t pixels = 0;
  double mean = 0;
  double standard_error = 0;  ///< of the mean
  double skewness = 0;        ///< of the pixels
  double rmse = 0;            ///< of a pixel against the truth
  double largest_sample = 0;
  double largest_share = 0;      ///< of one sample in the sum of all; 0 where all are 0
  double dark_pixels = 0;        ///< share of pixels whose samples all are 0
  std::uint64_t not_finite = 0;  ///< samples that are no finite number or below 0; counted as 0
  double nanoseconds = 0;        ///< processor time of a sample
  bool repeated = false;         ///< measured anew, because the first measurement looked biased
  Verdict verdict = Verdict::holds;

  /// Relative to the truth; as they are where the truth is 0.
  double relative(double value) const;
  double relative_bias() const { return relative(mean - truth.radiance); }
  double relative_rmse() const { return relative(rmse); }
  /// Student's t of the bias beyond what rounding explains, with Johnson's correction for skewed
  /// distributions (1978); 0 where rounding explains all.
  double z() const;
  /// Whether z means something: samples enough have met what the mean consists of. See
  /// stress_rule().
  bool resolved() const;
};

struct StressResult {
  std::vector<StressCell> cells;  ///< by case, setting, method
  double critical_z = 0;          ///< beyond which a bias is found; see stress_rule()
  bool complete = false;          ///< false when stopped: then there are no verdicts

  /// Cells that fail the run: not finite, or biased though the method claims not to be.
  std::vector<const StressCell*> failures() const;
};

/// The rule of the verdicts, for people.
std::string stress_rule(double critical_z);

/// Measures all, and what looks biased again with four times as many other pixels; settings are
/// shared among threads. `progress` gets the done and all settings, from one thread at a time.
StressResult run_stress(const StressPlan& plan, const std::atomic<bool>& stop,
                        const std::function<void(std::uint64_t, std::uint64_t)>& progress = {});

}  // namespace raytracing
