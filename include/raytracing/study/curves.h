#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace raytracing {

/// What a method reached at one number of samples.
struct CurvePoint {
  double seconds;  ///< > 0
  double error;    ///< > 0
};

/// The points in order of time.
std::vector<CurvePoint> by_time(std::vector<CurvePoint> points);

/// Error at a time, on the straight lines between points in (log time, log error). `curve` is in
/// order of time. Empty before the first point and after the last: nothing is extrapolated.
std::optional<double> error_at(std::span<const CurvePoint> curve, double seconds);

/// The first time at which those lines come down to `error`. Empty when they do not, and also when
/// the first point is already below: when that happened was not measured.
std::optional<double> time_to(std::span<const CurvePoint> curve, double error);

/// Indices, in order of time, of the points that no other beats in both time and error.
std::vector<std::size_t> pareto_front(std::span<const CurvePoint> points);

/// The numbers 1, 2 and 5 times a power of ten within [low, high]; low > 0. In rising order.
std::vector<double> round_numbers(double low, double high);

/// The middle one, or the mean of the middle two; there must be one.
double median(std::vector<double> values);

}  // namespace raytracing
