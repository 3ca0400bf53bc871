#include <gtest/gtest.h>

#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

TEST(LoadReports, KeepTheFirstName) {
  LoadReport report;
  for (const char* name : {"a", "b"})
    report.add(LoadReport::Severity::repaired, "lost", {"x", 1, 1}, name);
  ASSERT_EQ(report.entries().size(), 1u);
  EXPECT_EQ(report.entries()[0].name, "a");
  EXPECT_EQ(report.entries()[0].count, 2u);
}

TEST(LoadReports, CountByKindAndKeepTheFirstPlace) {
  using Severity = LoadReport::Severity;
  LoadReport report;
  report.add(Severity::ignored, "line", {"a.obj", 1, 1});
  report.add(Severity::dropped, "face", {"a.obj", 2, 1});
  for (long line = 3; line < 7; ++line) report.add(Severity::ignored, "line", "b.obj", {line, 1});
  report.add(Severity::ignored, "point", {"b.obj", 7, 1});
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
