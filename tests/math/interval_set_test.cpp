#include "raytracing/math/interval_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "support/statistics.h"

namespace raytracing {
namespace {

// A reference implementation: one flag for each unit cell [i, i+1).
class Cells {
 public:
  Cells(int begin, int end, int size) : left_(static_cast<std::size_t>(size)) {
    for (int i = begin; i < end; ++i) left_[static_cast<std::size_t>(i)] = true;
  }
  void subtract(int begin, int end) {
    for (int i = std::max(begin, 0); i < std::min(end, static_cast<int>(left_.size())); ++i)
      left_[static_cast<std::size_t>(i)] = false;
  }
  std::vector<std::pair<int, int>> runs() const {
    std::vector<std::pair<int, int>> result;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (!left_[i]) continue;
      if (i > 0 && left_[i - 1])
        ++result.back().second;
      else
        result.emplace_back(static_cast<int>(i), static_cast<int>(i) + 1);
    }
    return result;
  }

 private:
  std::vector<bool> left_;
};

// Returns the intervals of the set with touching neighbours merged: a gap of zero width makes no
// difference.
std::vector<std::pair<int, int>> joined(const IntervalSet& set, float scale) {
  std::vector<std::pair<int, int>> result;
  for (const Interval& part : set.intervals()) {
    const auto begin = static_cast<int>(part.begin / scale);
    const auto end = static_cast<int>(part.end / scale);
    if (!result.empty() && result.back().second == begin)
      result.back().second = end;
    else
      result.emplace_back(begin, end);
  }
  return result;
}

void expect_same(const IntervalSet& set, const Cells& cells, float scale) {
  const auto runs = cells.runs();
  ASSERT_EQ(joined(set, scale), runs);
  ASSERT_EQ(set.empty(), runs.empty());
  float end = -std::numeric_limits<float>::infinity(), sum = 0;
  for (const Interval& part : set.intervals()) {
    ASSERT_LT(part.begin, part.end);
    ASSERT_LE(end, part.begin);
    end = part.end;
    sum += part.length();
  }
  ASSERT_EQ(set.length(), sum);
  if (runs.empty()) return;
  ASSERT_EQ(set.hull().begin, static_cast<float>(runs.front().first) * scale);
  ASSERT_EQ(set.hull().end, static_cast<float>(runs.back().second) * scale);
}

// The ends are multiples of a power of two, so that comparisons are exact and many ends coincide.
TEST(IntervalSet, EqualsARowOfFlags) {
  TestRandom random(1);
  const auto below = [&](int n) {
    return static_cast<int>(random.bits() % static_cast<unsigned>(n));
  };
  for (int round = 0; round < 8000; ++round) {
    const int size = 4 + below(300);
    const int longest = 1 + below(std::max(1, size / 2));
    const float scale = round % 2 ? 1.0f : 0x1p-9f;
    const int whole_begin = below(size / 2), whole_end = whole_begin + 1 + below(size / 2);
    IntervalSet set(
        {static_cast<float>(whole_begin) * scale, static_cast<float>(whole_end) * scale});
    Cells cells(whole_begin, whole_end, size);
    expect_same(set, cells, scale);
    for (int cut = 0; cut < 60; ++cut) {
      const int begin = below(size + 8) - 4, end = begin + below(longest + 2) - 1;
      set.subtract(static_cast<float>(begin) * scale, static_cast<float>(end) * scale);
      cells.subtract(begin, end);
      expect_same(set, cells, scale);
      if (HasFatalFailure()) FAIL() << "round " << round << " cut " << cut;
    }
  }
}

// Cuts hundreds of holes in random order, then removes what remains. The number of intervals passes
// the capacity of the in-place storage in both directions.
TEST(IntervalSet, DropsNothingHoweverManyPartsThereAre) {
  TestRandom random(2);
  for (int count : {7, 8, 9, 10, 16, 17, 100, 500}) {
    IntervalSet set({0, static_cast<float>(2 * count + 1)});
    Cells cells(0, 2 * count + 1, 2 * count + 1);
    for (int first : {1, 0}) {
      std::vector<int> order;
      for (int i = first; i < 2 * count + 1; i += 2) order.push_back(i);
      for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random.bits() % i]);
      for (int i : order) {
        set.subtract(static_cast<float>(i), static_cast<float>(i + 1));
        cells.subtract(i, i + 1);
        expect_same(set, cells, 1.0f);
        if (HasFatalFailure()) FAIL() << count << " parts, cell " << i;
      }
      if (first == 1) {
        EXPECT_EQ(set.intervals().size(), static_cast<std::size_t>(count) + 1);
      }
    }
    EXPECT_TRUE(set.empty());
  }
}

TEST(IntervalSet, CopiesAreIndependent) {
  IntervalSet few({0, 100}), many({0, 100});
  few.subtract(1, 2);
  for (float hole = 1; hole < 80; hole += 2) many.subtract(hole, hole + 1);
  for (const IntervalSet& original : {few, many}) {
    const std::size_t parts = original.intervals().size();
    IntervalSet copy = original;
    copy.subtract(-1, 101);
    EXPECT_TRUE(copy.empty());
    EXPECT_EQ(original.intervals().size(), parts);
  }
}

TEST(IntervalSet, ExactTouchingTakesNothing) {
  IntervalSet set({0.25f, 0.75f});
  set.subtract(0, 0.25f);
  set.subtract(0.75f, 1);
  set.subtract(0.5f, 0.5f);
  set.subtract(0.6f, 0.4f);
  set.subtract(NAN, 1);
  set.subtract(0, NAN);
  ASSERT_EQ(set.intervals().size(), 1u);
  EXPECT_EQ(set.hull().begin, 0.25f);
  EXPECT_EQ(set.hull().end, 0.75f);
  EXPECT_EQ(set.length(), 0.5f);
  set.subtract(0.25f, 0.5f);
  set.subtract(0.5f, 0.75f);
  EXPECT_TRUE(set.empty());
  EXPECT_EQ(set.length(), 0.0f);
  set.subtract(0, 1);
  EXPECT_TRUE(set.empty());
}

// Intervals of the smallest possible length remain.
TEST(IntervalSet, KeepsPartsOfOneSpacing) {
  const float next = std::nextafter(0.5f, 1.0f);
  IntervalSet set({0, 1});
  set.subtract(0, 0.5f);
  set.subtract(next, 1);
  ASSERT_EQ(set.intervals().size(), 1u);
  EXPECT_EQ(set.hull().begin, 0.5f);
  EXPECT_EQ(set.hull().end, next);
  set.subtract(0.5f, next);
  EXPECT_TRUE(set.empty());
}

TEST(IntervalSet, WithoutLengthIsEmptyFromTheStart) {
  for (const Interval& whole : {Interval{1, 1}, Interval{1, 0}, Interval{0, NAN}}) {
    IntervalSet set(whole);
    EXPECT_TRUE(set.empty());
    EXPECT_EQ(set.intervals().size(), 0u);
    EXPECT_EQ(set.length(), 0.0f);
    set.subtract(0, 2);
    EXPECT_TRUE(set.empty());
  }
}

}  // namespace
}  // namespace raytracing
