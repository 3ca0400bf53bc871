#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "support/statistics.h"

namespace raytracing {

/// The p-values of one family of tests: a correct program fails the whole family with the
/// probability kFamilyLevel.
class PValues {
 public:
  void add(std::string name, double p) { tests_.emplace_back(std::move(name), p); }

  /// To be called once, at the end.
  void expect_all() const {
    ASSERT_FALSE(tests_.empty());
    const double level = sidak_level(kFamilyLevel, static_cast<double>(tests_.size()));
    for (const auto& [name, p] : tests_) EXPECT_GT(p, level) << name;
  }

 private:
  std::vector<std::pair<std::string, double>> tests_;
};

}  // namespace raytracing
