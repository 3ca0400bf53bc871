#include "raytracing/study/curves.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raytracing {
namespace {

// y at x on the line through (x0, y0) and (x1, y1), all of them drawn on logarithmic axes.
double log_interpolated(double x, double x0, double y0, double x1, double y1) {
  if (x0 == x1) return y0;
  return y0 * std::exp(std::log(y1 / y0) * std::log(x / x0) / std::log(x1 / x0));
}

}  // namespace

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
      // Dividing by a power that is exact gives the nearest number to the decimal one.
      const double number = e < 0 ? digit / std::pow(10, -e) : digit * std::pow(10, e);
      if (low <= number && number <= high) numbers.push_back(number);
    }
  return numbers;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

}  // namespace raytracing
