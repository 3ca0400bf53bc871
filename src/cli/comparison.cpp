#include "comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <variant>

#include "raytracing/io/errors.h"
#include "raytracing/study/metrics/flip.h"
#include "raytracing/study/metrics/reference.h"

namespace raytracing {
namespace {

// One number, for the table and the JSON alike.
struct Row {
  const char* key;
  std::string label;
  std::variant<double, std::uint64_t> value;
  std::string formula;
};

std::vector<Row> metric_rows(const ErrorMetrics& m) {
  const std::string epsilon = fmt::format("{}", kRelMseEpsilon);
  const std::string at =
      m.largest_x < 0 ? "" : fmt::format(" of a channel, at pixel {},{}", m.largest_x, m.largest_y);
  return {
      {"mse", "MSE", m.mse, "mean (x-r)^2"},
      {"rmse", "RMSE", m.rmse, "sqrt(MSE)"},
      {"relmse", "relMSE", m.relmse, "mean (x-r)^2 / (r^2 + " + epsilon + ")"},
      {"mae", "MAE", m.mae, "mean |x-r|"},
      {"psnr", "PSNR", m.psnr, "10 log10(1 / MSE) dB, for a peak of 1"},
      {"smape", "SMAPE", m.smape, "mean |x-r| / (|x| + |r| + " + epsilon + ")"},
      {"mean_ratio_r", "mean ratio R", m.mean_ratio.x, "mean x / mean r"},
      {"mean_ratio_g", "mean ratio G", m.mean_ratio.y, "mean x / mean r"},
      {"mean_ratio_b", "mean ratio B", m.mean_ratio.z, "mean x / mean r"},
      {"largest", "largest", m.largest, "|x-r|" + at},
      {"non_finite_test", "non-finite x", m.non_finite_test, "pixels, left out of the means"},
      {"non_finite_reference", "non-finite r", m.non_finite_reference,
       "pixels, left out of the means"},
  };
}

std::vector<Row> z_rows(const ZScores& z, const ExpectedScores& e) {
  const auto share = [&e](double expected) {
    if (e.overstated) return fmt::format("expected below {:.4f}: sobol overstates", expected);
    return fmt::format("expected {:.4f}{}", expected,
                       e.degrees == 0 ? "" : fmt::format(", Student's t with {}", e.degrees));
  };
  return {
      {"z_share_1.96", "|z| > 1.96", z.share_196,
       "share; z = (x-r) / sqrt(var x + var r); " + share(e.share_196)},
      {"z_share_3", "|z| > 3", z.share_3, "share; " + share(e.share_3)},
      {"z_mean", "mean z", z.mean, "expected 0, for many samples"},
      {"z_rms", "RMS z", z.rms,
       fmt::format("sqrt(mean z^2); expected {}{:.3g}", e.overstated ? "below " : "", e.rms)},
      {"z_scores", "z-scores", z.scores, "channels of pixels with a variance"},
      {"z_no_variance_equal", "var 0, x = r", z.no_variance_equal, "channels without a z-score"},
      {"z_no_variance_different", "var 0, x != r", z.no_variance_different,
       "channels without a z-score"},
      {"z_not_finite", "non-finite z", z.not_finite, "channels without a z-score"},
  };
}

std::vector<Row> rows(const Comparison& c) {
  std::vector<Row> result = metric_rows(c.metrics);
  const auto after_smape = result.begin() + 6;
  result.insert(after_smape,
                {"flip", "FLIP", c.flip,
                 fmt::format("mean LDR-FLIP, {} pixels per degree, values cut off to 0..1, "
                             "NaN to 0",
                             kFlipPixelsPerDegree)});
  if (!c.z) return result;
  for (const Row& row : z_rows(*c.z, c.expected)) result.push_back(row);
  return result;
}

void add_notes_on(const ImageData& image, const RunFacts& facts, const std::string& path,
                  std::vector<std::string>& notes) {
  if (facts.light_sampling_biased == true)
    notes.push_back(
        fmt::format("note: {}: made by the biased method {}: more samples do not bring "
                    "it to the true picture",
                    path, facts.light_sampling.value_or("")));
  if (facts.complete == false)
    notes.push_back(fmt::format("warning: {}: its rendering was stopped early", path));
  if (has_correlated_pixels(facts))
    notes.push_back(fmt::format("note: {}: {}", path, *facts.pixel_correlation));
  if (image.integer_bits > 0)
    notes.push_back(fmt::format("note: {}: {} bits a channel, and light beyond 1 is cut off", path,
                                image.integer_bits));
}

}  // namespace

std::string comparison_text(const Comparison& c) {
  std::string text =
      fmt::format("x = {}\nr = {}\nmeans over R, G and B of {} pixels\n", one_line(c.test_path),
                  one_line(c.reference_path), c.metrics.pixels);
  for (const Row& row : rows(c)) {
    const double* real = std::get_if<double>(&row.value);
    const std::string number =
        real ? fmt::format("{:.6g}", *real) : fmt::format("{}", std::get<std::uint64_t>(row.value));
    text += fmt::format("{:<14} {:>12}  {}\n", row.label, number, row.formula);
  }
  return text;
}

std::string comparison_json(const Comparison& c) {
  nlohmann::ordered_json j, formulas;
  j["test"] = c.test_path;
  j["reference"] = c.reference_path;
  j["pixels"] = c.metrics.pixels;
  for (const Row& row : rows(c)) {
    std::visit([&](auto v) { j[row.key] = v; }, row.value);
    formulas[row.key] = row.formula;
  }
  j["largest_pixel"] = nullptr;
  if (c.metrics.largest_x >= 0) j["largest_pixel"] = {c.metrics.largest_x, c.metrics.largest_y};
  j["epsilon"] = kRelMseEpsilon;
  j["formulas"] = formulas;
  return j.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::vector<std::string> header_notes(const ImageData& test, const std::string& test_path,
                                      const ImageData& reference,
                                      const std::string& reference_path) {
  std::vector<std::string> notes;
  const RunFacts x = facts_of(test.metadata), r = facts_of(reference.metadata);
  const bool both = x.scene_hash && r.scene_hash;
  if (both && x.scene_hash != r.scene_hash)
    notes.push_back(fmt::format("warning: of different scenes: scene_hash {} and {}", *x.scene_hash,
                                *r.scene_hash));
  if (both && x.scene_hash == r.scene_hash && x.seed && x.seed == r.seed && x.sampler &&
      x.sampler == r.sampler)
    notes.push_back("note: both pictures have the same seed: their errors are not independent");
  add_notes_on(test, x, test_path, notes);
  add_notes_on(reference, r, reference_path, notes);
  return notes;
}

}  // namespace raytracing
