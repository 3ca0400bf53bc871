#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace raytracing {

/// A part of the parameter range of a segment.
struct Interval {
  float begin, end;
  float length() const { return end - begin; }
};

/// What is left of an interval after parts of it are taken away: sorted, disjoint intervals of
/// positive length. The first few live in place; more go to the heap, none is ever dropped.
class IntervalSet {
 public:
  explicit IntervalSet(const Interval& whole) : size_(whole.end > whole.begin ? 1 : 0) {
    inline_[0] = whole;
  }

  /// Takes [begin, end] away. Nothing happens when end <= begin.
  void subtract(float begin, float end);

  bool empty() const { return size_ == 0; }
  std::span<const Interval> intervals() const { return {data(), size_}; }
  /// From the first point left to the last. The set must not be empty.
  Interval hull() const { return {data()[0].begin, data()[size_ - 1].end}; }
  /// Sum of the lengths.
  float length() const;

 private:
  static constexpr std::size_t kInline = 8;
  Interval* data() { return heap_.empty() ? inline_.data() : heap_.data(); }
  const Interval* data() const { return heap_.empty() ? inline_.data() : heap_.data(); }
  void insert(std::size_t index, const Interval& interval);
  void erase(std::size_t first, std::size_t last);

  std::array<Interval, kInline> inline_;
  std::vector<Interval> heap_;  // in use when not empty; then of at least size_ elements
  std::size_t size_;
};

}  // namespace raytracing
