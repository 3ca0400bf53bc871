#include "raytracing/study/chart_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart_tables.h"
#include "raytracing/io/file.h"
#include "raytracing/io/image_reader.h"
#include "raytracing/study/error_picture.h"

namespace raytracing {
namespace {

// The longest time up to which every method has been measured.
double common_time(const ChartSummary& summary) {
  double time = INFINITY;
  for (const MethodSummary& m : summary.methods) {
    double longest = 0;
    for (const ChartPoint& p : m.points) longest = std::max(longest, p.seconds.median);
    time = std::min(time, longest);
  }
  return time;
}

// What the method reaches within that time; where even its first point takes longer, that one.
const ChartPoint& best_within(const MethodSummary& method, double seconds) {
  const ChartPoint* best = &method.points.front();
  for (const ChartPoint& p : method.points)
    if (p.seconds.median <= seconds && p.spp > best->spp) best = &p;
  return *best;
}

// Its left upper part: an error picture has its legend below, and may be wider.
ImageData cropped(const ImageData& image, int width, int height) {
  ImageData result{width, height, image.channels, {}, {}};
  const auto row = static_cast<std::ptrdiff_t>(image.channels.size());
  for (int y = 0; y < height; ++y) {
    const auto begin = image.values.begin() + row * image.width * y;
    result.values.insert(result.values.end(), begin, begin + row * width);
  }
  return result;
}

// Without the header: the page says how all was made.
std::string png(const ImageData& image) {
  return encode_image({image.width, image.height, image.channels, image.values, {}},
                      ImageFormat::png);
}

ReportPicture picture_of(const MethodSummary& method, double seconds, const RunLog& log,
                         const Reference& reference, const PixelMask& counted) {
  const ChartPoint& point = best_within(method, seconds);
  const std::string_view name = method.method->name;
  const ChartRun& run = *log.find(name, point.spp, 0);
  const ImageData image = read_image(log.picture_path(name, point.spp, 0));
  const ImageData errors = error_picture(image, reference.picture, counted);
  return {fmt::format("{}{}", name, method.method->unbiased ? "" : " (biased)"),
          fmt::format("{} spp in {:.3g} s (median), of at most {:.3g} s; relMSE {:.3g}", point.spp,
                      point.seconds.median, seconds, run.relmse),
          png(image), png(cropped(errors, image.width, image.height))};
}

std::vector<ReportPicture> pictures(const ChartSummary& summary, const RunLog& log,
                                    const Reference& reference, const PixelMask& counted) {
  std::vector<ReportPicture> result;
  for (const MethodSummary& method : summary.methods)
    result.push_back(picture_of(method, common_time(summary), log, reference, counted));
  const std::string noise =
      summary.floor ? fmt::format("its own relMSE is about {:.2g}", summary.floor->relmse.value)
                    : "its own noise is not known";
  result.push_back({"reference", noise, png(reference.picture), ""});
  return result;
}

// At a time at which all methods were measured.
std::string best_at(const ChartSummary& summary, double seconds) {
  std::vector<std::pair<double, std::string>> ranks;
  for (const MethodSummary& m : summary.methods)
    ranks.emplace_back(*error_at(m.curve, seconds), std::string(m.method->name));
  std::sort(ranks.begin(), ranks.end());
  std::string text =
      fmt::format("In {:.3g} s, the least relMSE (median over the seeds) is that of {}: {:.3g}",
                  seconds, ranks.front().second, ranks.front().first);
  for (std::size_t i = 1; i < ranks.size(); ++i)
    text += fmt::format("{} {} has {:.2f} times as much", i == 1 ? ";" : ",", ranks[i].second,
                        ranks[i].first / ranks[0].first);
  return text + ".";
}

std::vector<std::string> notes(const ChartSummary& summary) {
  std::vector<std::string> result;
  std::vector<double> times;  // at which all methods were measured
  for (const double seconds : summary.times)
    if (std::all_of(summary.methods.begin(), summary.methods.end(),
                    [seconds](const auto& m) { return error_at(m.curve, seconds).has_value(); }))
      times.push_back(seconds);
  if (!times.empty()) result.push_back(best_at(summary, times.front()));
  if (times.size() > 1) result.push_back(best_at(summary, times.back()));
  for (const MethodSummary& m : summary.methods)
    if (m.bias() && m.bias()->detected)
      result.push_back(fmt::format("{}: {}.", m.method->name, to_text(*m.bias())));
  result.push_back(
      "Methods whose bands overlap in the charts are not told apart by so few seeds. relMSE is "
      "the " +
      relmse_formula() +
      " over pixels and channels, with x the picture and r the reference. The error maps show it "
      "per pixel, on a logarithmic scale from black (1e-5 and less) over red to light yellow (10 "
      "and more).");
  return result;
}

}  // namespace

Report chart_report(const ChartSettings& settings, const ChartSummary& summary, const RunLog& log,
                    const Reference& reference, const PixelMask& counted, bool has_charts,
                    std::vector<std::pair<std::string, std::string>> facts) {
  Report report;
  report.title = "Error against time: " + chart_title(settings);
  report.notes = notes(summary);
  report.pictures = pictures(summary, log, reference, counted);
  if (has_charts)
    report.charts = {
        {"Error against render time: median and min-max band over the seeds",
         read_file(settings.folder + "/error_vs_time.svg")},
        {"Error against samples per pixel", read_file(settings.folder + "/error_vs_spp.svg")}};
  report.tables = chart_tables(summary);
  report.facts = std::move(facts);
  report.facts.emplace_back("seeds", std::to_string(settings.seeds));
  report.facts.emplace_back("noise of the reference", reference.variance_source);
  return report;
}

}  // namespace raytracing
