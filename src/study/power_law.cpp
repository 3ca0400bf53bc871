#include "raytracing/study/power_law.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace raytracing {
// A finite sum for a whole number of degrees of freedom (Abramowitz and Stegun 1964,
// 26.7.3 and 26.7.4).
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

double PowerLaw::at(double x) const { return std::exp(log_scale + slope * std::log(x)); }

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

}  // namespace raytracing
