// The report page's contents; report_browser_test.py has what the page makes of them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "raytracing/study/page/report_page.h"
#include "study/report_example.h"

namespace raytracing {
namespace {

using Json = nlohmann::json;

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// The contents as the page's script reads them.
Json contents(const std::string& html) {
  const std::string begin = "<script type=\"application/json\" id=\"report\">";
  const std::size_t at = html.find(begin) + begin.size();
  return Json::parse(html.substr(at, html.find("</script>", at) - at));
}

TEST(Base64, HasTheVectorsOfRfc4648) {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, encoded] : vectors) EXPECT_EQ(base64(bytes), encoded);
}

TEST(Base64, TakesAllBytesAndUsesAllDigits) {
  EXPECT_EQ(base64(std::string("\x00\xff\x80\n", 4)), "AP+ACg==");
  EXPECT_EQ(base64("\xff\xff\xff\xfb\xef\xbe"), "////++++");
}

TEST(ReportHtml, HoldsEveryField) {
  const Report report = example_report();
  const Json j = contents(report_html(report));
  EXPECT_EQ(j["title"], report.title);
  EXPECT_EQ(j["notes"], Json(report.notes));
  ASSERT_EQ(j["pictures"].size(), report.pictures.size());
  for (std::size_t i = 0; i < report.pictures.size(); ++i) {
    const ReportPicture& picture = report.pictures[i];
    EXPECT_EQ(j["pictures"][i], Json({{"label", picture.label},
                                      {"details", picture.details},
                                      {"png", base64(picture.png)},
                                      {"error_png", base64(picture.error_png)}}));
  }
  ASSERT_EQ(j["charts"].size(), report.charts.size());
  for (std::size_t i = 0; i < report.charts.size(); ++i) {
    EXPECT_EQ(j["charts"][i]["caption"], report.charts[i].caption);
    EXPECT_EQ(j["charts"][i]["svg"], base64(report.charts[i].svg));
  }
  ASSERT_EQ(j["tables"].size(), report.tables.size());
  for (std::size_t i = 0; i < report.tables.size(); ++i) {
    EXPECT_EQ(j["tables"][i]["caption"], report.tables[i].caption);
    EXPECT_EQ(j["tables"][i]["header"], Json(report.tables[i].header));
    EXPECT_EQ(j["tables"][i]["rows"], Json(report.tables[i].rows));
  }
  ASSERT_EQ(j["facts"].size(), report.facts.size());
  for (std::size_t i = 0; i < report.facts.size(); ++i) {
    EXPECT_EQ(j["facts"][i]["name"], report.facts[i].first);
    EXPECT_EQ(j["facts"][i]["value"], report.facts[i].second);
    EXPECT_NE(j["facts"][i]["meaning"], "");
  }
}

// No text of the report is taken for a part of the page, and any bytes make a page.
TEST(ReportHtml, KeepsTextsApartFromThePage) {
  const int scripts = count(report_html({}), "</script>");
  Report report;
  report.title = "</script><script>alert(1)</script><!-- {{report}} \\ \"";
  report.notes = {"ü 5 × 10⁻³", "not UTF-8: \xff"};
  const std::string html = report_html(report);
  EXPECT_EQ(count(html, "</script>"), scripts);
  EXPECT_EQ(html.find("<!-- {{"), std::string::npos);
  const Json j = contents(html);
  EXPECT_EQ(j["title"], report.title);
  EXPECT_EQ(j["notes"][0], report.notes[0]);
  EXPECT_EQ(j["notes"][1], "not UTF-8: \xef\xbf\xbd");
}

TEST(ReportHtml, ListsOfEmptyPartsAreEmpty) {
  const Json j = contents(report_html({}));
  for (const char* part : {"notes", "pictures", "charts", "tables", "facts"})
    EXPECT_EQ(j[part], Json::array()) << part;
}

// What a page can ask the network for: attributes that name resources, url() and @import in CSS,
// requests and imports of scripts.
TEST(ReportHtml, NeedsNoOtherFileAndNoNetwork) {
  const std::string html = report_html(example_report());
  for (const char* attribute : {"src", "href", "srcset", "poster", "data", "action"}) {
    EXPECT_EQ(count(html, fmt::format(" {}=", attribute)),
              count(html, fmt::format(" {}=\"data:", attribute)))
        << attribute;
  }
  for (const char* part : {"://", "url(", "@import", "fetch(", "XMLHttpRequest", "import(", "<link",
                           "<iframe", "{{report}}"}) {
    EXPECT_EQ(html.find(part), std::string::npos) << part;
  }
  EXPECT_NE(html.find("content=\"default-src 'none'; img-src data:;"), std::string::npos);
}

}  // namespace
}  // namespace raytracing
