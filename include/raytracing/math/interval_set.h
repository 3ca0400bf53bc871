#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace raytracing {

/// An interval of the parameter of a segment.
struct Interval {
  float begin, end;
  float length() const { return end - begin; }
};

/// A set of sorted, disjoint intervals of positive length: what remains of one interval after parts
/// have been subtracted. The first few intervals are stored in place, more on the heap; none is
/// ever dropped.
class IntervalSet {
 public:
  explicit IntervalSet(const Interval& whole) : size_(whole.end > whole.begin ? 1 : 0) {
    inline_[0] = whole;
  }

  /// Removes [begin, end] from the set. The set does not change when end <= begin.
  void subtract(float begin, float end);

  bool empty() const { return size_ == 0; }
  std::span<const Interval> intervals() const { return {data(), size_}; }
  /// The smallest interval that contains the set, which must not be empty.
  Interval hull() const { return {data()[0].begin, data()[size_ - 1].end}; }
  /// The sum of the lengths of all intervals.
  float length() const;

 private:
  static constexpr std::size_t kInline = 8;
  Interval* data() { return heap_.empty() ? inline_.data() : heap_.data(); }
  const Interval* data() const { return heap_.empty() ? inline_.data() : heap_.data(); }
  void insert(std::size_t index, const Interval& interval);
  void erase(std::size_t first, std::size_t last);

  std::array<Interval, kInline> inline_;
  std::vector<Interval> heap_;  // holds all intervals unless it is empty; then inline_ does
  std::size_t size_;
};

}  // namespace raytracing
