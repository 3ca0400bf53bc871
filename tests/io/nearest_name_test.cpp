#include "raytracing/io/nearest_name.h"

#include <gtest/gtest.h>

namespace raytracing {
namespace {

TEST(NearestName, CountsInsertionsErasuresAndReplacements) {
  EXPECT_EQ(nearest_name("wdth", {"height", "width"}), "width");
  EXPECT_EQ(nearest_name("widthh", {"height", "width"}), "width");
  EXPECT_EQ(nearest_name("wadth", {"height", "width"}), "width");
  EXPECT_EQ(nearest_name("", {"longer", "up"}), "up");
  EXPECT_EQ(nearest_name("x", {"a", "b"}), "a");
}

}  // namespace
}  // namespace raytracing
