#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace raytracing {

/// The middle value, or the mean of the middle two; there must be at least one value.
double median(std::vector<double> values);

/// P(|T| <= t) for Student's distribution with `degrees` >= 1 degrees of freedom; t >= 0.
double student_t_probability(double t, int degrees);

/// The t >= 0 with P(|T| <= t) = `probability` for Student's distribution with `degrees` >= 1
/// degrees of freedom; 0 <= probability < 1.
double student_t_quantile(double probability, int degrees);

/// y = exp(log_scale) * x^slope, the straight line of least squares through (log x, log y).
struct PowerLaw {
  struct Interval {
    double low, high;
  };

  double slope = 0;
  double slope_error = 0;  ///< standard error, from the same scatter; 0 for two points
  double log_scale = 0;    ///< log y at x = 1
  /// 95 % interval of the slope, from the scatter of the points about the line: noise and bend of
  /// the curve both widen it. Empty for two points, which have no scatter.
  std::optional<Interval> slope_interval;
  int points = 0;
};

/// Fits a power law; empty without two different x. All x and y must be above 0.
std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y);

/// The error that a method reached at one number of samples.
struct CurvePoint {
  double seconds;  ///< > 0
  double error;    ///< > 0
};

/// The same points in order of time.
std::vector<CurvePoint> by_time(std::vector<CurvePoint> points);

/// The error at a time, on the straight lines between points in (log time, log error). `curve` is
/// in order of time. Empty before the first point and after the last: nothing is extrapolated.
std::optional<double> error_at(std::span<const CurvePoint> curve, double seconds);

/// The first time at which those lines come down to `error`. Empty when they do not, and also when
/// the first point is already below, since an earlier time was not measured.
std::optional<double> time_to(std::span<const CurvePoint> curve, double error);

/// Indices, in order of time, of the points that no other beats in both time and error.
std::vector<std::size_t> pareto_front(std::span<const CurvePoint> points);

/// The numbers 1, 2 and 5 times a power of ten within [low, high]; low > 0. In rising order.
std::vector<double> round_numbers(double low, double high);

}  // namespace raytracing
