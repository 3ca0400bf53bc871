#include "raytracing/study/page/report_page.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "embedded/report_page.h"

namespace raytracing {
namespace {

using Json = nlohmann::json;

Json json(const ReportPicture& picture) {
  return {{"label", picture.label},
          {"details", picture.details},
          {"png", base64(picture.png)},
          {"error_png", base64(picture.error_png)}};
}

Json json(const ReportChart& chart) {
  return {{"caption", chart.caption}, {"svg", base64(chart.svg)}};
}

Json json(const ReportTable& table) {
  return {{"caption", table.caption}, {"header", table.header}, {"rows", table.rows}};
}

Json json(const std::pair<std::string, std::string>& fact) {
  const auto fields = fact_fields();
  const auto known = std::find_if(fields.begin(), fields.end(),
                                  [&](const FactField& field) { return field.name == fact.first; });
  return {{"name", fact.first},
          {"value", fact.second},
          {"meaning", known == fields.end() ? "" : known->meaning}};
}

template <class Element>
Json json(const std::vector<Element>& elements) {
  Json list = Json::array();
  for (const Element& element : elements) list.push_back(json(element));
  return list;
}

void replace_all(std::string& text, std::string_view part, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += by.size())
    text.replace(at, part.size(), by);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> fact_rows(const RunFacts& facts) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [name, value] : named_values(facts)) rows.emplace_back(name, to_text(value));
  return rows;
}

std::string method_label(const DirectMethod& method) {
  return std::string(method.name) + (method.unbiased ? "" : " (biased)");
}

std::string report_html(const Report& report) {
  constexpr std::string_view kPlace = "{{report}}";
  const Json contents = {{"title", report.title},
                         {"notes", report.notes},
                         {"pictures", json(report.pictures)},
                         {"charts", json(report.charts)},
                         {"tables", json(report.tables)},
                         {"facts", json(report.facts)}};
  std::string text = contents.dump(-1, ' ', false, Json::error_handler_t::replace);
  replace_all(text, "<", "\\u003c");  // no text of the report ends or opens an element of the page
  std::string page(kReportPage);
  return page.replace(page.find(kPlace), kPlace.size(), text);
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  while (!bytes.empty()) {
    const std::string_view group = bytes.substr(0, 3);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8 | (i < group.size() ? static_cast<unsigned char>(group[i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i)
      out += i <= group.size() ? kDigits[bits >> (18 - 6 * i) & 63] : '=';
    bytes.remove_prefix(group.size());
  }
  return out;
}

}  // namespace raytracing
