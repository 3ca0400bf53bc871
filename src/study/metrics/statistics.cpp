#include "raytracing/study/metrics/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace raytracing {
namespace {

// The y at x of the straight line through (x0, y0) and (x1, y1) on logarithmic axes.
double log_interpolated(double x, double x0, double y0, double x1, double y1) {
  if (x0 == x1) return y0;
  return y0 * std::exp(std::log(y1 / y0) * std::log(x / x0) / std::log(x1 / x0));
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

// The sum is finite for a whole number of degrees of freedom (Abramowitz and Stegun 1964, 26.7.3
// and 26.7.4).
double student_t_probability(double t, int degrees) {
  const double angle = std::atan(t / std::sqrt(degrees));
  const double cosine = std::cos(angle);
  const bool odd = degrees % 2 == 1;
  double term = odd ? cosine : 1, sum = 0;
  for (int k = odd ? 2 : 1; k < degrees; k += 2) {
    sum += term;
    term *= cosine * cosine * k / (k + 1);
  }
  return odd ? 2 / std::numbers::pi * (angle + std::sin(angle) * sum) : std::sin(angle) * sum;
}

double student_t_quantile(double probability, int degrees) {
  double low = 0, high = 1;
  while (student_t_probability(high, degrees) < probability) high *= 2;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (student_t_probability(middle, degrees) < probability ? low : high) = middle;
  }
  return (low + high) / 2;
}

std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y) {
  const double n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, residuals = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / n;
    mean_y += std::log(y[i]) / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = std::log(x[i]) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(y[i]) - mean_y);
  }
  if (!(xx > 0)) return std::nullopt;
  PowerLaw fit;
  fit.points = static_cast<int>(x.size());
  fit.slope = xy / xx;
  fit.log_scale = mean_y - fit.slope * mean_x;
  if (fit.points < 3) return fit;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double r = std::log(y[i]) - fit.log_scale - fit.slope * std::log(x[i]);
    residuals += r * r;
  }
  fit.slope_error = std::sqrt(residuals / (n - 2) / xx);
  const double half = student_t_quantile(0.95, fit.points - 2) * fit.slope_error;
  fit.slope_interval = PowerLaw::Interval{fit.slope - half, fit.slope + half};
  return fit;
}

std::vector<CurvePoint> by_time(std::vector<CurvePoint> points) {
  std::stable_sort(points.begin(), points.end(),
                   [](const CurvePoint& a, const CurvePoint& b) { return a.seconds < b.seconds; });
  return points;
}

std::optional<double> error_at(std::span<const CurvePoint> curve, double seconds) {
  if (curve.size() == 1 && curve[0].seconds == seconds) return curve[0].error;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const CurvePoint &a = curve[i], &b = curve[i + 1];
    if (a.seconds <= seconds && seconds <= b.seconds)
      return log_interpolated(seconds, a.seconds, a.error, b.seconds, b.error);
  }
  return std::nullopt;
}

std::optional<double> time_to(std::span<const CurvePoint> curve, double error) {
  if (curve.empty() || curve[0].error < error) return std::nullopt;
  if (curve[0].error == error) return curve[0].seconds;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const CurvePoint &a = curve[i], &b = curve[i + 1];
    if (b.error <= error) return log_interpolated(error, a.error, a.seconds, b.error, b.seconds);
  }
  return std::nullopt;
}

std::vector<std::size_t> pareto_front(std::span<const CurvePoint> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].seconds != points[b].seconds ? points[a].seconds < points[b].seconds
                                                  : points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || points[i].error < points[front.back()].error) front.push_back(i);
  return front;
}

std::vector<double> round_numbers(double low, double high) {
  std::vector<double> numbers;
  for (double e = std::floor(std::log10(low)); std::pow(10, e) <= high; e += 1)
    for (const double digit : {1.0, 2.0, 5.0}) {
      // Division by an exact power of ten gives the float nearest to the decimal number.
      const double number = e < 0 ? digit / std::pow(10, -e) : digit * std::pow(10, e);
      if (low <= number && number <= high) numbers.push_back(number);
    }
  return numbers;
}

}  // namespace raytracing
