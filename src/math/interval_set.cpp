#include "raytracing/math/interval_set.h"

#include <algorithm>

namespace raytracing {

void IntervalSet::subtract(float begin, float end) {
  if (!(end > begin)) return;
  Interval* parts = data();
  std::size_t first = 0;
  while (first < size_ && parts[first].end <= begin) ++first;
  if (first == size_ || parts[first].begin >= end) return;

  Interval& touched = parts[first];
  if (touched.begin < begin) {
    const float old_end = touched.end;
    touched.end = begin;
    if (old_end > end) {
      insert(first + 1, {end, old_end});
      return;
    }
    ++first;
  }
  std::size_t last = first;
  while (last < size_ && parts[last].end <= end) ++last;
  if (last < size_) parts[last].begin = std::max(parts[last].begin, end);
  erase(first, last);
}

float IntervalSet::length() const {
  float sum = 0;
  for (const Interval& part : intervals()) sum += part.length();
  return sum;
}

void IntervalSet::insert(std::size_t index, const Interval& interval) {
  if (heap_.empty() && size_ == kInline) heap_.assign(inline_.begin(), inline_.end());
  if (!heap_.empty()) heap_.resize(std::max(heap_.size(), size_ + 1));
  Interval* parts = data();
  std::copy_backward(parts + index, parts + size_, parts + size_ + 1);
  parts[index] = interval;
  ++size_;
}

void IntervalSet::erase(std::size_t first, std::size_t last) {
  Interval* parts = data();
  std::copy(parts + last, parts + size_, parts + first);
  size_ -= last - first;
}

}  // namespace raytracing
