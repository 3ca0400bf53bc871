#include "raytracing/io/load_report.h"

#include <gtest/gtest.h>

namespace raytracing {
namespace {

TEST(InputErrors, NameThePlaceAsFarAsItIsKnown) {
  EXPECT_EQ(to_string(TextLocation{"a.obj", 3, 7}), "a.obj:3:7");
  EXPECT_EQ(to_string(TextLocation{"a.obj", 3, 0}), "a.obj:3");
  EXPECT_EQ(to_string(TextLocation{"a.obj", 0, 7}), "a.obj");
  EXPECT_EQ(to_string(TextLocation{"", 3, 7}), "3:7");
  EXPECT_STREQ(InputError(TextLocation{}, "why").what(), "why");
  EXPECT_STREQ(InputError(TextLocation{"a\nb", 1, 2}, "c\r\nd").what(), "a b:1:2: c  d");
}

TEST(LoadReports, KeepTheFirstName) {
  LoadReport report;
  for (const char* name : {"a", "b"})
    report.add(LoadReport::Severity::repaired, "lost", {"x", 1, 1}, 1, name);
  ASSERT_EQ(report.entries().size(), 1u);
  EXPECT_EQ(report.entries()[0].name, "a");
  EXPECT_EQ(report.entries()[0].count, 2u);
}

TEST(LoadReports, CountByKindAndKeepTheFirstPlace) {
  using Severity = LoadReport::Severity;
  LoadReport report;
  report.add(Severity::ignored, "line", {"a.obj", 1, 1});
  report.add(Severity::dropped, "face", {"a.obj", 2, 1});
  report.add(Severity::ignored, "line", {"b.obj", 3, 1}, 4);
  report.add(Severity::ignored, "point", {"b.obj", 4, 1});
  report.add(Severity::warning, "line", {"b.obj", 5, 1}, 0);
  ASSERT_EQ(report.entries().size(), 3u);
  EXPECT_EQ(report.entries()[0].count, 5u);
  EXPECT_EQ(to_string(report.entries()[0].first), "a.obj:1:1");
  EXPECT_EQ(report.entries()[1].kind, "face");
  EXPECT_EQ(report.count(Severity::ignored), 6u);
  EXPECT_EQ(report.count(Severity::dropped), 1u);
  EXPECT_EQ(report.count(Severity::repaired), 0u);
  EXPECT_STREQ(to_string(Severity::repaired), "repaired");
}

}  // namespace
}  // namespace raytracing
