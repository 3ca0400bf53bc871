#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"
#include "comparison.h"
#include "option_list.h"
#include "output_paths.h"
#include "raytracing/cli/app.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/io/image_reader.h"
#include "raytracing/study/error_picture.h"
#include "raytracing/study/flip.h"

namespace raytracing {
namespace {

struct CompareArguments {
  std::string test, reference;
  std::string mask, diff, z_scores, json;  // "" = none
  std::optional<double> max_relmse;
  std::optional<std::string> help;
};

CompareArguments parse_compare_arguments(const Arguments& arguments) {
  CompareArguments a;
  OptionList options(
      "Compares picture A with the reference B, both EXR or PNG (decoded to linear).",
      "Raytracing compare");
  options.add_text("A", a.test, "FILE", "The picture to judge");
  options.add_text("B", a.reference, "FILE", "The reference");
  options.add_text("--mask", a.mask, "FILE",
                   "Picture of the same size: only pixels where it is white (linear mean of R, G, "
                   "B >= 0.5) count");
  options.add_text("--diff", a.diff, "FILE",
                   "Write the relative squared error of each pixel in false colours, .png or .exr: "
                   "black (1e-5 and less) to light yellow (10 and more); cyan is not finite, grey "
                   "lies outside of the mask");
  options.add_text("--z-scores", a.z_scores, "FILE.exr",
                   "Write the z-score of each channel of each pixel; NaN where there is none");
  options.add_real("--max-relmse", a.max_relmse, 0, std::numeric_limits<double>::max(),
                   "End with exit code 1 when relMSE is above this limit, or A has pixels that are "
                   "not finite");
  options.add_text("--json", a.json, "FILE", "Write the numbers and their formulas as JSON");
  options.add_footer(
      "1 means above the limit; 3 also pictures of different sizes, a mask without "
      "white pixels,\nand --z-scores of pictures without variance layers.\n");
  a.help = options.parse(arguments);
  if (a.help) return a;
  if (a.reference.empty()) throw_usage("two pictures are needed");
  if (!a.diff.empty()) image_format(a.diff);
  check_distinct({a.test, a.reference, a.mask}, {a.diff, a.z_scores, a.json});
  if (!a.z_scores.empty() && image_format(a.z_scores) != ImageFormat::exr)
    throw_usage("--z-scores: " + a.z_scores + " is no .exr: z-scores are negative too");
  return a;
}

// Whether the picture passes; a picture with pixels that are not finite has no finite error.
bool within_limit(const ErrorMetrics& m, const std::optional<double>& limit) {
  if (!limit) return true;
  if (m.non_finite_test > 0) {
    fmt::print(stderr, "Raytracing: {} pixels are not finite\n", m.non_finite_test);
    return false;
  }
  if (m.relmse <= *limit) return true;
  fmt::print(stderr, "Raytracing: relMSE {:.6g} is not within --max-relmse {}\n", m.relmse, *limit);
  return false;
}

}  // namespace

int compare_command(const Arguments& arguments) {
  const CompareArguments a = parse_compare_arguments(arguments);
  if (a.help) {
    fmt::print("{}", *a.help);
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
    throw InputError("no pixel counts: all are outside of the mask or not finite");
  std::optional<std::string> z_bytes;
  if (!a.z_scores.empty())
    z_bytes = encode_image(z_score_picture(test, reference), ImageFormat::exr);
  std::optional<OutputFile> diff, z_picture, json;
  if (!a.diff.empty()) diff.emplace(a.diff);
  if (!a.z_scores.empty()) z_picture.emplace(a.z_scores);
  if (!a.json.empty()) json.emplace(a.json);
  for (const std::string& note : header_notes(test, a.test, reference, a.reference))
    fmt::print(stderr, "{}\n", one_line(note));
  fmt::print("{}", comparison_text(comparison));
  if (diff) {
    diff->write(encode_image(error_picture(test, reference, mask), image_format(a.diff)));
    diff->commit();
  }
  if (z_picture) {
    z_picture->write(*z_bytes);
    z_picture->commit();
  }
  if (json) {
    json->write(comparison_json(comparison));
    json->commit();
  }
  return within_limit(comparison.metrics, a.max_relmse) ? kExitGood : kExitCheckFailed;
}

}  // namespace raytracing
