#pragma once

#include <optional>
#include <string>
#include <vector>

#include "raytracing/io/image.h"
#include "raytracing/study/metrics/error_metrics.h"
#include "raytracing/study/metrics/z_scores.h"

namespace raytracing {

/// All numbers of a comparison of a test picture x with a reference r.
struct Comparison {
  std::string test_path, reference_path;
  ErrorMetrics metrics;
  double flip;
  std::optional<ZScores> z;
  ExpectedScores expected;
};

/// A table: name, number, formula.
std::string comparison_text(const Comparison& comparison);

/// The same as one JSON object, whose "formulas" has the formulas under the numbers' names. Numbers
/// that are infinite or none are null.
std::string comparison_json(const Comparison& comparison);

/// What the pictures' headers say against the comparison, a line each: made from different scenes,
/// with the same random numbers, by a biased method, unfinished, or stored in 8 bits.
std::vector<std::string> header_notes(const ImageData& test, const std::string& test_path,
                                      const ImageData& reference,
                                      const std::string& reference_path);

}  // namespace raytracing
