#pragma once

#include <cstddef>
#include <string>

#include "raytracing/io/image.h"
#include "raytracing/study/page/report_page.h"

namespace raytracing {

/// A picture of one colour (0 or 1 in each channel) whose top left quarter is a checkerboard of
/// single pixels, black and of that colour, as PNG.
inline std::string example_png(int red, int green, int blue) {
  ImageData image{480, 300, {"R", "G", "B"}, {}, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool black = x < image.width / 2 && y < image.height / 2 && (x + y) % 2 == 1;
      for (const int value : {red, green, blue}) {
        image.values.push_back(black ? 0.0f : static_cast<float>(value));
      }
    }
  }
  return encode_image(image, "png");
}

/// Every part of a report, with characters that HTML would take for itself.
inline Report example_report() {
  Report report;
  report.title = "Cornell <Box> & \"friends\"";
  report.notes = {"First note: a < b.", "Second note: {{title}} stays as it is."};
  report.pictures = {
      {"point", "16 spp, 0.42 s, relMSE 0.0031", example_png(1, 0, 0), example_png(1, 1, 0)},
      {"line <i>&'exact'</i>", "4 spp, 0.43 s, relMSE 0.0007", example_png(0, 1, 0),
       example_png(1, 0, 1)},
      {"reference", "4096 spp, 90 s", example_png(0, 0, 1), ""}};
  report.charts = {
      {"Error against time",
       R"(<svg xmlns="http://www.w3.org/2000/svg" width="640" height="200" viewBox="0 0 640 200">)"
       R"(<script>window.chartScriptRan = true</script>)"
       R"(<path id="stage" d="M20 20L620 180" stroke="#06c" stroke-width="3"/></svg>)"}};
  report.tables = {{"At equal time",
                    {"method", "relMSE", "speed"},
                    {{"point", "3.1e-3", "-"}, {"line", "7e-4", "4.4 x"}}}};
  report.facts = {{"command", "Raytracing chart --scene 'a b.toml' --out <dir>"},
                  {"build", "Release, AVX2"}};
  return report;
}

/// Tables alone: columns of numbers and of other cells, rows of any length.
inline Report report_of_tables() {
  Report report;
  report.title = "Tables";
  report.tables = {{"columns",
                    {"text", "number", "with unit", "signed", "mixed", "nothing"},
                    {{"a", "1", "1 s", "-1", "1", "-"}, {"b", ".5e3", "2 s", "+2", "none", ""}}},
                   {"lengths", {"a", "b"}, {{"1"}, {"2", "3", "4"}, {}}}};
  return report;
}

}  // namespace raytracing
