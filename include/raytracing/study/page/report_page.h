#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/render/provenance.h"

namespace raytracing {

/// A picture of the viewer.
struct ReportPicture {
  std::string label;      ///< short name, for example of the method; shown in the select boxes
  std::string details;    ///< what it cost, for example "16 spp, 0.42 s, relMSE 0.0031"
  std::string png;        ///< bytes of a PNG file, sRGB
  std::string error_png;  ///< bytes of a PNG file, false colours; empty: no error map
};

/// A chart, for example as written by gnuplot.
struct ReportChart {
  std::string caption;
  std::string svg;  ///< an SVG document; shown as a picture, so that nothing in it is executed
};

/// A table. A column is set flush right when its cells begin with a number or are empty or "-".
struct ReportTable {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// The contents of the page, from top to bottom. All text is plain text in UTF-8, not HTML.
struct Report {
  std::string title;
  std::vector<std::string> notes;  ///< paragraphs below the title: what to conclude
  /// Of one size, at about equal time. The first two are shown first; a reference may be the last.
  std::vector<ReportPicture> pictures;
  std::vector<ReportChart> charts;
  std::vector<ReportTable> tables;
  std::vector<std::pair<std::string, std::string>> facts;  ///< how it was made: name and value
};

/// The known facts of a run as rows for Report::facts.
std::vector<std::pair<std::string, std::string>> fact_rows(const RunFacts& facts);

/// The name of a method as pages and charts show it: "line-ratio (biased)".
std::string method_label(const DirectMethod& method);

/// The report as one HTML page that needs no other file and no network: two pictures under a
/// draggable divider, with zoom and error maps, then charts, tables and how it was made. The page
/// holds the contents as JSON, from which its script builds these parts; an empty one is left out.
std::string report_html(const Report& report);

/// Encodes bytes in Base64 with padding, RFC 4648 section 4.
std::string base64(std::string_view bytes);

}  // namespace raytracing
