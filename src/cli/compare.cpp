#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app.h"
#include "common_options.h"
#include "compare_notes.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/io/image.h"
#include "raytracing/study/metrics/error_metrics.h"
#include "raytracing/study/metrics/error_picture.h"
#include "raytracing/study/metrics/flip.h"
#include "raytracing/study/metrics/overlap.h"
#include "raytracing/study/metrics/z_scores.h"

namespace raytracing {
namespace {

struct CompareArguments {
  std::string test, reference;
  std::string layer, reference_layer;      // "" = the picture itself
  std::string mask, diff, z_scores, json;  // "" = none
  std::optional<double> max_relmse;
};

CompareArguments parse_compare_arguments(const Arguments& arguments) {
  CompareArguments a;
  OptionList options(
      "Compares image A with the reference image B. Both are EXR, PNG, TIFF, JPEG, HDR, PFM or PNM "
      "files. Colour profiles, gamma and chromaticities are converted to linear Rec. 709; integers "
      "without them are sRGB. Of images that are parts of one picture, the pixels that both have "
      "are compared.",
      "Raytracing compare");
  options.value("A", a.test, "FILE", "Image to evaluate.");
  options.value("B", a.reference, "FILE", "Reference image.");
  add_mask_option(options, a.mask);
  options.value("--layer", a.layer, "NAME",
                "Layer of A to compare, for example 'direct' or 'ViewLayer.DiffDir'. Default: the "
                "channels R, G, B, or the layer that is called beauty or Combined.");
  options.value("--reference-layer", a.reference_layer, "NAME", "The same for B.");
  options.value("--diff", a.diff, "FILE",
                "Write the relative squared error of each pixel in false colour, from "
                "black (1e-5 or less) to light yellow (10 or more). Pixels that are not finite are "
                "cyan, pixels outside the mask grey.");
  options.value(
      "--z-scores", a.z_scores, "FILE",
      "Write the z-score of each channel of each pixel to this .exr file; NaN where it is "
      "undefined. At least one image needs variance channels.");
  options.real("--max-relmse", a.max_relmse, 0, std::numeric_limits<double>::max(),
               "Fail with exit code 1 if relMSE is above X or A contains pixels that are not "
               "finite.");
  options.value("--json", a.json, "FILE", "Write all values and their formulas as JSON.");
  options.footer(
      "The input is also invalid (3) if the images differ in size, have no pixel in common, the "
      "mask\n"
      "selects no pixel, or --z-scores is given but no image has variance channels.\n");
  options.parse(arguments.values);
  if (a.reference.empty()) throw_usage("two images are needed");
  if (!a.diff.empty()) image_ending(a.diff);
  check_distinct({a.test, a.reference, a.mask}, {a.diff, a.z_scores, a.json});
  if (!a.z_scores.empty() && image_ending(a.z_scores) != "exr")
    throw_usage("--z-scores: " + a.z_scores + " is not an .exr file; z-scores may be negative");
  return a;
}

/// The images x and r, and all values that compare them.
struct Comparison {
  std::string test_path, reference_path;
  PixelWindow window;  ///< the pixels that are compared, of the whole picture
  ErrorMetrics metrics;
  double flip;
  std::optional<ZScores> z;
  ExpectedScores expected;
};

// One value of the comparison, as it appears in the table and in the JSON file.
struct Row {
  const char* key;
  std::string label;
  std::variant<double, std::uint64_t> value;
  std::string formula;
};

std::vector<Row> metric_rows(const ErrorMetrics& m, const PixelWindow& window, double flip) {
  const std::string epsilon = fmt::format("{}", kRelMseEpsilon);
  const std::string at = m.largest_x < 0
                             ? ""
                             : fmt::format(" of a channel, at pixel {},{}", window.x + m.largest_x,
                                           window.y + m.largest_y);
  return {
      {"mse", "MSE", m.mse, "mean (x-r)^2"},
      {"rmse", "RMSE", m.rmse, "sqrt(MSE)"},
      {"relmse", "relMSE", m.relmse, "mean (x-r)^2 / (r^2 + " + epsilon + ")"},
      {"mae", "MAE", m.mae, "mean |x-r|"},
      {"psnr", "PSNR", m.psnr, "10 log10(1 / MSE) dB, for a peak of 1"},
      {"smape", "SMAPE", m.smape, "mean |x-r| / (|x| + |r| + " + epsilon + ")"},
      {"flip", "FLIP", flip,
       fmt::format("mean LDR-FLIP, {} pixels per degree, values clamped to 0..1, NaN to 0",
                   kFlipPixelsPerDegree)},
      {"mean_ratio_r", "mean ratio R", m.mean_ratio.x, "mean x / mean r"},
      {"mean_ratio_g", "mean ratio G", m.mean_ratio.y, "mean x / mean r"},
      {"mean_ratio_b", "mean ratio B", m.mean_ratio.z, "mean x / mean r"},
      {"largest", "largest", m.largest, "|x-r|" + at},
      {"non_finite_test", "non-finite x", m.non_finite_test, "pixels, excluded from the means"},
      {"non_finite_reference", "non-finite r", m.non_finite_reference,
       "pixels, excluded from the means"},
  };
}

std::vector<Row> z_rows(const ZScores& z, const ExpectedScores& e) {
  const auto share = [&e](double expected) {
    if (e.overstated)
      return fmt::format("expected below {:.4f}: sobol variances are overestimated", expected);
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
  std::vector<Row> result = metric_rows(c.metrics, c.window, c.flip);
  if (!c.z) return result;
  for (const Row& row : z_rows(*c.z, c.expected)) result.push_back(row);
  return result;
}

// Returns a table with the name, value and formula in each row.
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

// Returns the same as a JSON object. Its key "formulas" maps each name to its formula; values that
// are not finite become null.
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
  if (c.metrics.largest_x >= 0)
    j["largest_pixel"] = {c.window.x + c.metrics.largest_x, c.window.y + c.metrics.largest_y};
  j["epsilon"] = kRelMseEpsilon;
  j["formulas"] = formulas;
  return j.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

// An optional output, created before the images are compared.
class Output {
 public:
  explicit Output(const std::string& path) {
    if (!path.empty()) file_.emplace(path);
  }
  explicit operator bool() const { return file_.has_value(); }
  void write(const std::string& bytes) {
    file_->write(bytes);
    file_->commit();
  }

 private:
  std::optional<OutputFile> file_;
};

// Whether the image passes; an image with pixels that are not finite has no finite error.
bool within_limit(const ErrorMetrics& m, const std::optional<double>& limit) {
  if (!limit) return true;
  if (m.non_finite_test > 0) {
    print_message("Raytracing: {} pixels are not finite\n", m.non_finite_test);
    return false;
  }
  if (m.relmse <= *limit) return true;
  print_message("Raytracing: relMSE {:.6g} exceeds --max-relmse {}\n", m.relmse, *limit);
  return false;
}

}  // namespace

int compare_command(const Arguments& arguments) {
  const CompareArguments a = parse_compare_arguments(arguments);
  ImageData test = read_image(a.test, a.layer);
  ImageData reference = read_image(a.reference, a.reference_layer);
  const auto window = common_window(test, reference);
  if (!window)
    throw InputError(fmt::format("{}: {}, but {} has {}", a.test, pixels_text(test), a.reference,
                                 pixels_text(reference)));
  Output diff(a.diff), z_scores(a.z_scores), json(a.json);
  std::vector<std::string> notes =
      comparison_notes({a.test, test}, {a.reference, reference}, *window);
  const PixelWindow whole = whole_of(test);
  const PixelMask mask = read_mask(a.mask, whole.width, whole.height, *window, notes);
  test = cropped(test, *window);
  reference = cropped(reference, *window);
  const Comparison comparison{a.test,
                              a.reference,
                              *window,
                              error_metrics(test, reference, mask),
                              masked_mean(flip_map(test, reference), mask),
                              raytracing::z_scores(test, reference, mask),
                              expected_scores(test, reference)};
  if (comparison.metrics.pixels == 0)
    throw InputError(
        fmt::format("{} and {}: no pixel to compare: all are outside the mask or not "
                    "finite",
                    a.test, a.reference));
  ImageData z_picture;
  if (z_scores) z_picture = z_score_picture(test, reference);
  z_picture.whole = test.whole;
  for (const std::string& note : notes) print_message("{}\n", one_line(note));
  fmt::print("{}", comparison_text(comparison));
  // The picture of errors comes last, since not every format can hold it.
  if (json) json.write(comparison_json(comparison));
  if (z_scores) z_scores.write(encode_image(z_picture, "exr"));
  if (diff) diff.write(encode_image(error_picture(test, reference, mask), image_ending(a.diff)));
  return within_limit(comparison.metrics, a.max_relmse) ? kExitGood : kExitCheckFailed;
}

}  // namespace raytracing
