// What made a sample infinite or not a number, told from the log of its path.

#include "raytracing/integrator/path_log.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace raytracing {
namespace {

const Vec3 kNan(0, std::numeric_limits<float>::quiet_NaN(), 0);
const Vec3 kInfinite(std::numeric_limits<float>::infinity(), 0, 0);

PathLog::Step sound() { return {Vec3(1), Vec3(0, 0, 1), Rgb(1), Rgb(0), Rgb(2), 0, 1}; }

TEST(NonFiniteCauses, TheFirstAlongThePathIsToBlame) {
  PathLog log{{sound(), sound(), sound()}};
  EXPECT_EQ(non_finite_cause(log), NonFiniteCause::sum);
  log.steps[2].position = kNan;
  EXPECT_EQ(non_finite_cause(log), NonFiniteCause::geometry);
  log.steps[1].direct = kInfinite;
  EXPECT_EQ(non_finite_cause(log), NonFiniteCause::direct_light);
  log.steps[1].emitted = kNan;
  EXPECT_EQ(non_finite_cause(log), NonFiniteCause::emission);
  log.steps[1].throughput = kInfinite;
  EXPECT_EQ(non_finite_cause(log), NonFiniteCause::bsdf);
  log.steps[0].normal = kNan;
  EXPECT_EQ(non_finite_cause(log), NonFiniteCause::geometry);
}

TEST(NonFiniteCauses, HaveNames) {
  EXPECT_EQ(to_string(NonFiniteCause::geometry), std::string("geometry"));
  EXPECT_EQ(to_string(NonFiniteCause::sum), std::string("sum"));
}

}  // namespace
}  // namespace raytracing
