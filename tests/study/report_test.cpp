#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../../src/study/page/html_template.h"
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

/// How often the page has the bytes as a data URI of this type.
int count_data(const std::string& html, const char* type, const std::string& bytes) {
  return count(html, fmt::format("\"data:{};base64,{}\"", type, base64(bytes)));
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

TEST(EscapeHtml, ReplacesWhatHtmlTakesForItself) {
  EXPECT_EQ(escape_html(R"(<a href="x" id='y'>&amp;</a>)"),
            "&lt;a href=&quot;x&quot; id=&#39;y&#39;&gt;&amp;amp;&lt;/a&gt;");
  EXPECT_EQ(escape_html("ü 5 × 10⁻³"), "ü 5 × 10⁻³");
}

TEST(FillTemplate, EscapesRepeatsAndLeavesOut) {
  const Json data = {{"name", "a<b"},
                     {"none", nullptr},
                     {"empty", ""},
                     {"no_rows", Json::array()},
                     {"texts", {"x", "{{name}}"}},
                     {"rows", {{{"cell", "1"}}, {{"cell", "2"}, {"name", "inner"}}}}};
  EXPECT_EQ(fill_template("", data), "");
  EXPECT_EQ(fill_template("{{name}}|{{! no }}|{{name}}", data), "a&lt;b||a&lt;b");
  EXPECT_EQ(fill_template("{{#texts}}[{{.}}]{{/texts}}", data), "[x][{{name}}]");
  EXPECT_EQ(fill_template("{{#rows}}{{cell}}{{name}} {{/rows}}{{name}}", data),
            "1a&lt;b 2inner a&lt;b");
  EXPECT_EQ(fill_template("{{#name}}({{.}}){{/name}}", data), "(a&lt;b)");
  EXPECT_EQ(
      fill_template("-{{#none}}1{{/none}}{{#empty}}2{{/empty}}{{#no_rows}}3{{/no_rows}}-", data),
      "--");
}

TEST(FillTemplate, RefusesWrongTemplates) {
  for (const char* text : {"{{other}}", "{{name", "{{#name}}", "{{#name}}{{/other}}"}) {
    EXPECT_THROW(fill_template(text, {{"name", "x"}}), std::logic_error) << text;
  }
}

TEST(ReportHtml, HoldsEveryField) {
  const Report report = example_report();
  const std::string html = report_html(report);
  const auto expect_text = [&](const std::string& text) {
    EXPECT_NE(html.find(fmt::format(">{}<", escape_html(text))), std::string::npos) << text;
  };
  EXPECT_EQ(count(html, fmt::format(">{}<", escape_html(report.title))), 2);
  for (const std::string& note : report.notes) expect_text(note);
  for (const ReportPicture& picture : report.pictures) {
    expect_text(picture.label);
    expect_text(picture.details);
    EXPECT_EQ(count_data(html, "image/png", picture.png), 1);
    if (picture.error_png.empty()) continue;
    EXPECT_EQ(count_data(html, "image/png", picture.error_png), 1);
  }
  EXPECT_EQ(count(html, "data:image/png;base64,"), 5);
  for (const ReportChart& chart : report.charts) {
    expect_text(chart.caption);
    EXPECT_EQ(count_data(html, "image/svg+xml", chart.svg), 1);
  }
  for (const ReportTable& table : report.tables) {
    expect_text(table.caption);
    for (const std::string& cell : table.header) expect_text(cell);
    for (const auto& row : table.rows) {
      for (const std::string& cell : row) expect_text(cell);
    }
  }
  for (const auto& [name, value] : report.facts) {
    expect_text(name);
    expect_text(value);
  }
}

TEST(ReportHtml, SetsColumnsOfNumbersFlushRight) {
  Report report;
  report.tables = {{"caption",
                    {"text", "number", "with unit", "signed", "mixed", "nothing"},
                    {{"a", "1", "1 s", "-1", "1", "-"}, {"b", ".5e3", "2 s", "+2", "none", ""}}}};
  const std::string html = report_html(report);
  const auto is_number = [&](const char* name) {
    return count(html, fmt::format("class=\"number\">{}<", name)) == 1;
  };
  for (const char* name : {"number", "with unit", "signed"}) EXPECT_TRUE(is_number(name)) << name;
  for (const char* name : {"text", "mixed", "nothing"}) EXPECT_FALSE(is_number(name)) << name;
  EXPECT_EQ(count(html, "class=\"number\""), 9);
}

TEST(ReportHtml, TakesRowsOfAnyLength) {
  Report report;
  report.tables = {{"caption", {"a", "b"}, {{"1"}, {"2", "3", "4"}, {}}}};
  EXPECT_EQ(count(report_html(report), "<td"), 4);
}

TEST(ReportHtml, LeavesOutEmptyParts) {
  const std::string empty = report_html({});
  for (const char* part : {"<section", "<img", "<table", "<dl", "<script"}) {
    EXPECT_EQ(empty.find(part), std::string::npos) << part;
  }
  Report report = example_report();
  report.pictures.resize(1);
  report.pictures[0].error_png.clear();
  EXPECT_EQ(count(report_html(report), "class=\"error\""), 0);
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
                           "<iframe", "{{#", "{{/"}) {
    EXPECT_EQ(html.find(part), std::string::npos) << part;
  }
  EXPECT_NE(html.find("content=\"default-src 'none'; img-src data:;"), std::string::npos);
}

}  // namespace
}  // namespace raytracing
