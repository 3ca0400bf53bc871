#include "raytracing/study/page/report_page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "embedded/report_page.h"
#include "html_template.h"

namespace raytracing {
namespace {

using Json = nlohmann::json;

// Whether the cell begins with digits, after an optional sign or point; a unit may follow.
bool begins_with_number(std::string_view cell) {
  cell.remove_prefix(std::min(cell.find_first_not_of("+-."), cell.size()));
  return !cell.empty() && cell.front() >= '0' && cell.front() <= '9';
}

// Whether all cells of the column begin with numbers; cells without letters and digits are empty
// ones.
bool is_number_column(const ReportTable& table, std::size_t column) {
  bool found = false;
  for (const std::vector<std::string>& row : table.rows) {
    if (column >= row.size()) continue;
    if (row[column].find_first_not_of("+-. ") == std::string::npos) continue;
    if (!begins_with_number(row[column])) return false;
    found = true;
  }
  return found;
}

Json to_json(const ReportTable& table) {
  std::vector<const char*> align;  // of each column
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    align.push_back(is_number_column(table, i) ? "number" : "text");
  }
  const auto cells = [&align](const std::vector<std::string>& row) {
    Json result = Json::array();
    for (std::size_t i = 0; i < row.size(); ++i) {
      result.push_back({{"text", row[i]}, {"align", i < align.size() ? align[i] : "text"}});
    }
    return result;
  };
  Json rows = Json::array();
  for (const std::vector<std::string>& row : table.rows) rows.push_back({{"cells", cells(row)}});
  return {{"caption", table.caption}, {"header", cells(table.header)}, {"rows", std::move(rows)}};
}

Json to_json(const ReportPicture& picture) {
  return {{"label", picture.label},
          {"details", picture.details},
          {"png", base64(picture.png)},
          {"error_png", base64(picture.error_png)}};
}

Json to_json(const ReportChart& chart) {
  return {{"caption", chart.caption}, {"svg", base64(chart.svg)}};
}

Json to_json(const std::pair<std::string, std::string>& fact) {
  const auto fields = fact_fields();
  const auto known = std::find_if(fields.begin(), fields.end(),
                                  [&](const FactField& field) { return field.name == fact.first; });
  return {{"name", fact.first},
          {"value", fact.second},
          {"meaning", known == fields.end() ? "" : known->meaning}};
}

// One part of the page with its heading; null leaves it out.
template <class Element>
Json part(const std::vector<Element>& elements) {
  if (elements.empty()) return nullptr;
  Json list = Json::array();
  for (const Element& element : elements) list.push_back(to_json(element));
  return {{"list", std::move(list)}};
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
  return fill_template(kReportPage, {{"title", report.title},
                                     {"notes", report.notes},
                                     {"pictures", part(report.pictures)},
                                     {"charts", part(report.charts)},
                                     {"tables", part(report.tables)},
                                     {"facts", part(report.facts)}});
}

}  // namespace raytracing
