#include "raytracing/lights/chord_integral.h"

#include <algorithm>
#include <cmath>

#include "raytracing/math/numeric.h"

namespace raytracing {
namespace {

// Returns (x - sin x) / sin^3 x for the angle x in (0, pi) with this sine and cosine. Where the
// difference would cancel, it is a series in the square of the sine.
float angle_excess(float sine, float cosine) {
  const float s2 = square(sine);
  if (sine < 0.343f && cosine > 0)
    return 1.0f / 6 + s2 * (3.0f / 40 + s2 * (15.0f / 336 + s2 * (105.0f / 3456)));
  return (std::atan2(sine, cosine) - sine) / (sine * s2);
}

}  // namespace

SeenChord::SeenChord(const Chord& chord, const Vec3& from, const Vec3& light_normal)
    : direction_(chord.direction), length_(chord.length) {
  const Vec3 to_begin = chord.begin - from;
  const Vec3 to_end = to_begin + chord.length * chord.direction;
  begin_ = dot(to_begin, direction_);
  // The foot is computed from the nearer end, which has the smaller rounding error.
  if (dot(to_begin, to_begin) <= dot(to_end, to_end)) {
    foot_ = to_begin - begin_ * direction_;
  } else {
    const float end = dot(to_end, direction_);
    foot_ = to_end - end * direction_;
    begin_ = end - length_;
  }
  foot_distance2_ = dot(foot_, foot_);
  height_ = -dot(foot_, light_normal);
}

Interval SeenChord::above_horizon(const Vec3& n, const Interval& whole) const {
  const float at_foot = dot(n, foot_), slope = dot(n, direction_);
  const float a = at_foot + position(whole.begin) * slope;
  const float b = at_foot + position(whole.end) * slope;
  if (a >= 0 && b >= 0) return whole;
  if (a <= 0 && b <= 0) return {whole.begin, whole.begin};
  const float cut = whole.begin + whole.length() * (a / (a - b));
  return a < 0 ? Interval{cut, whole.end} : Interval{whole.begin, cut};
}

float SeenChord::irradiance(const Vec3& n, const Interval& part) const {
  if (!(height_ > 0) || !(part.length() > 0)) return 0;
  const float s0 = position(part.begin), s1 = position(part.end);
  const float length = part.length() * length_;
  const float l0 = std::sqrt(foot_distance2_ + s0 * s0);
  const float l1 = std::sqrt(foot_distance2_ + s1 * s1);
  const float product = l0 * l1;
  const float q = length / product;

  const float sine = std::sqrt(foot_distance2_) * q;
  const float cosine = (foot_distance2_ + s0 * s1) / product;
  const float sum = plus_product_of_roots(foot_distance2_, s0, s1, product);
  const float difference = (s0 + s1) * length / (l0 + l1);  // l1 - l0 without cancellation
  const float e = q * q * q * angle_excess(sine, cosine) +
                  q / product * (difference * difference + length * length) / (2 * sum);
  const float n_foot = dot(n, foot_);
  const float n_middle = n_foot + 0.5f * (s0 + s1) * dot(n, direction_);
  return std::max(0.0f, height_ * (n_middle * q / product + 0.5f * n_foot * e));
}

}  // namespace raytracing
