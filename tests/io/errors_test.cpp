#include "raytracing/io/errors.h"

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

TEST(NearestName, CountsInsertionsErasuresAndReplacements) {
  EXPECT_EQ(nearest_name("wdth", {"height", "width"}), "width");
  EXPECT_EQ(nearest_name("widthh", {"height", "width"}), "width");
  EXPECT_EQ(nearest_name("wadth", {"height", "width"}), "width");
  EXPECT_EQ(nearest_name("", {"longer", "up"}), "up");
  EXPECT_EQ(nearest_name("x", {"a", "b"}), "a");
}

}  // namespace
}  // namespace raytracing
