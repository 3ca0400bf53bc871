#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"
#include "common_options.h"
#include "comparison.h"
#include "raytracing/cli/app.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/io/image.h"
#include "raytracing/study/metrics/error_picture.h"
#include "raytracing/study/metrics/flip.h"

namespace raytracing {
namespace {

struct CompareArguments {
  std::string test, reference;
  std::string mask, diff, z_scores, json;  // "" = none
  std::optional<double> max_relmse;
  std::optional<std::string> text;  // printed instead of comparing: the help
};

CompareArguments parse_compare_arguments(const Arguments& arguments) {
  CompareArguments a;
  OptionList options(
      "Compares image A with the reference image B. Both are EXR or PNG files; PNG values are "
      "decoded from sRGB to linear.",
      "Raytracing compare");
  options.text("A", a.test, "FILE", "Image to evaluate.");
  options.text("B", a.reference, "FILE", "Reference image.");
  add_mask_option(options, a.mask);
  options.text("--diff", a.diff, "FILE",
               "Write the relative squared error of each pixel in false colour, .png or .exr, from "
               "black (1e-5 or less) to light yellow (10 or more). Pixels that are not finite are "
               "cyan, pixels outside the mask grey.");
  options.text("--z-scores", a.z_scores, "FILE",
               "Write the z-score of each channel of each pixel to this .exr file; NaN where it is "
               "undefined. Both images need variance channels.");
  options.real("--max-relmse", a.max_relmse, 0, std::numeric_limits<double>::max(),
               "Fail with exit code 1 if relMSE is above X or A contains pixels that are not "
               "finite.");
  options.text("--json", a.json, "FILE", "Write all values and their formulas as JSON.");
  options.footer(
      "The input is also invalid (3) if the images differ in size, the mask selects no pixel, or\n"
      "--z-scores is given for images without variance channels.\n");
  a.text = options.parse(arguments.values);
  if (a.text) return a;
  if (a.reference.empty()) throw_usage("two images are needed");
  if (!a.diff.empty()) image_format(a.diff);
  check_distinct({a.test, a.reference, a.mask}, {a.diff, a.z_scores, a.json});
  if (!a.z_scores.empty() && image_format(a.z_scores) != ImageFormat::exr)
    throw_usage("--z-scores: " + a.z_scores + " is not an .exr file; z-scores may be negative");
  return a;
}

// An optional output, created before the work is done.
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
    fmt::print(stderr, "Raytracing: {} pixels are not finite\n", m.non_finite_test);
    return false;
  }
  if (m.relmse <= *limit) return true;
  fmt::print(stderr, "Raytracing: relMSE {:.6g} exceeds --max-relmse {}\n", m.relmse, *limit);
  return false;
}

}  // namespace

int compare_command(const Arguments& arguments) {
  const CompareArguments a = parse_compare_arguments(arguments);
  if (a.text) {
    fmt::print("{}", *a.text);
    return kExitGood;
  }
  const ImageData test = read_image(a.test), reference = read_image(a.reference);
  if (test.width != reference.width || test.height != reference.height)
    throw InputError(fmt::format("{}: {}x{} pixels, but {} has {}x{}", a.test, test.width,
                                 test.height, a.reference, reference.width, reference.height));
  const PixelMask mask = read_mask(a.mask, test.width, test.height);
  const Comparison comparison{a.test,
                              a.reference,
                              error_metrics(test, reference, mask),
                              masked_mean(flip_map(test, reference), mask),
                              z_scores(test, reference, mask),
                              expected_scores(test, reference)};
  if (comparison.metrics.pixels == 0)
    throw InputError("no pixel to compare: all are outside the mask or not finite");
  std::string z_bytes;
  if (!a.z_scores.empty())
    z_bytes = encode_image(z_score_picture(test, reference), ImageFormat::exr);
  Output diff(a.diff), z_scores(a.z_scores), json(a.json);
  for (const std::string& note : header_notes(test, a.test, reference, a.reference))
    fmt::print(stderr, "{}\n", one_line(note));
  fmt::print("{}", comparison_text(comparison));
  if (diff) diff.write(encode_image(error_picture(test, reference, mask), image_format(a.diff)));
  if (z_scores) z_scores.write(z_bytes);
  if (json) json.write(comparison_json(comparison));
  return within_limit(comparison.metrics, a.max_relmse) ? kExitGood : kExitCheckFailed;
}

}  // namespace raytracing
