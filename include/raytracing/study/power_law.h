#pragma once

#include <optional>
#include <span>

namespace raytracing {

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
  /// the curve both widen it. Empty for two points, which tell nothing of their scatter.
  std::optional<Interval> slope_interval;
  int points = 0;

  double at(double x) const;
};

/// Needs two different x; otherwise empty. All x and y must be above 0.
std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y);

}  // namespace raytracing
