#pragma once
// Statistics for the tests: means, z-tests, chi-square tests, quadrature, seeded random numbers.
// A test asks for a p-value and expects it above `sidak_level(kFamilyLevel, number of tests)`.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "raytracing/math/vec.h"
#include "raytracing/sampling/hash.h"

namespace raytracing {

/// Probability that a correct program fails one family of tests. Seeds are fixed, so a family that
/// passed once passes again; the level says how surprising a failure is after a change.
inline constexpr double kFamilyLevel = 1e-3;

/// Level of each of `tests` independent tests such that all together have the level `family`
/// (Sidak's correction).
inline double sidak_level(double family, double tests) {
  return -std::expm1(std::log1p(-family) / tests);
}

/// Pseudo-random numbers with a fixed seed, the same with every standard library.
class TestRandom {
 public:
  explicit TestRandom(std::uint64_t seed) : engine_(seed) {}
  std::uint64_t bits() { return engine_(); }
  float unit() { return unit_float(static_cast<std::uint32_t>(bits() >> 32)); }  ///< [0,1)
  float between(float a, float b) { return a + (b - a) * unit(); }
  Vec2 unit2() {
    const float x = unit();
    return {x, unit()};
  }
  /// Uniform in the cube [-size, size]^3.
  Vec3 in_cube(float size) {
    const float x = between(-size, size), y = between(-size, size);
    return {x, y, between(-size, size)};
  }
  /// A uniform unit vector.
  Vec3 direction() {
    for (;;) {
      const Vec3 v = in_cube(1.0f);
      const float l2 = dot(v, v);
      if (l2 > 1e-4f && l2 <= 1) return normalize(v);
    }
  }

 private:
  std::mt19937_64 engine_;
};

/// Mean and variance of numbers that come one by one (Welford 1962).
class RunningStats {
 public:
  void add(double x) {
    ++count_;
    const double delta = x - mean_;
    mean_ += delta / static_cast<double>(count_);
    squares_ += delta * (x - mean_);
  }
  std::size_t count() const { return count_; }
  double mean() const { return mean_; }
  /// Unbiased variance of one number; 0 for fewer than two.
  double variance() const { return count_ < 2 ? 0.0 : squares_ / static_cast<double>(count_ - 1); }
  /// Standard deviation of the mean.
  double standard_error() const {
    return count_ == 0 ? 0.0 : std::sqrt(variance() / static_cast<double>(count_));
  }

 private:
  std::size_t count_ = 0;
  double mean_ = 0, squares_ = 0;
};

/// Two-sided p-value of a standard normal number.
inline double normal_p_value(double z) { return std::erfc(std::abs(z) / std::numbers::sqrt2); }

/// p-value of "the mean is `expected`". `rounding` is an error of the numbers themselves that is
/// allowed besides the random one.
inline double mean_p_value(const RunningStats& stats, double expected, double rounding = 0) {
  const double distance = std::max(0.0, std::abs(stats.mean() - expected) - rounding);
  if (distance == 0) return 1;
  return stats.standard_error() > 0 ? normal_p_value(distance / stats.standard_error()) : 0.0;
}

/// p-value of "both have the same mean" (Welch; many samples each).
inline double same_mean_p_value(const RunningStats& a, const RunningStats& b, double rounding = 0) {
  const double distance = std::max(0.0, std::abs(a.mean() - b.mean()) - rounding);
  if (distance == 0) return 1;
  const double error = std::hypot(a.standard_error(), b.standard_error());
  return error > 0 ? normal_p_value(distance / error) : 0.0;
}

/// Regularised upper incomplete gamma function Q(a, x): series below a + 1, Lentz's continued
/// fraction above (Press et al. 2007, section 6.2).
inline double gamma_q(double a, double x) {
  if (x <= 0) return 1;
  const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (double n = a + 1; std::abs(term) > 1e-16 * sum; n += 1) sum += term *= x / n;
    return 1 - front * sum;
  }
  double b = x + 1 - a, c = 1e300, d = 1 / b, h = d;
  for (int i = 1; i < 100000; ++i) {
    const double an = -i * (i - a);
    b += 2;
    d = 1 / (an * d + b);
    c = b + an / c;
    h *= c * d;
    if (std::abs(c * d - 1) < 1e-15) break;
  }
  return front * h;
}

struct ChiSquare {
  double statistic = 0;
  int degrees = 0;
  double p_value = 1;
};

/// Pearson's test of counts against expected counts, which are scaled to the same total. Cells that
/// expect fewer than 5 are pooled into one. A count where nothing is expected gives p = 0.
inline ChiSquare chi_square_test(std::span<const double> observed,
                                 std::span<const double> expected) {
  double total = 0, expected_total = 0;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    total += observed[i];
    expected_total += expected[i];
  }
  const double scale = total / expected_total;
  std::vector<std::size_t> order(observed.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  ChiSquare result;
  double pooled = 0, pooled_expected = 0;
  for (std::size_t i : order) {
    if (expected[i] <= 0 && observed[i] > 0) return {INFINITY, 1, 0.0};
    pooled += observed[i];
    pooled_expected += expected[i] * scale;
    if (pooled_expected < 5) continue;
    result.statistic += (pooled - pooled_expected) * (pooled - pooled_expected) / pooled_expected;
    ++result.degrees;
    pooled = pooled_expected = 0;
  }
  --result.degrees;  // the totals agree
  if (result.degrees > 0) result.p_value = gamma_q(0.5 * result.degrees, 0.5 * result.statistic);
  return result;
}

/// The same against equal expectations.
inline ChiSquare chi_square_uniform(std::span<const double> observed) {
  return chi_square_test(observed, std::vector<double>(observed.size(), 1.0));
}

/// Index of the cell of x in [0,1] among n; x = 1 counts to the last.
inline std::size_t cell_of(double x, std::size_t n) {
  return static_cast<std::size_t>(
      std::clamp(x * static_cast<double>(n), 0.0, static_cast<double>(n) - 1));
}

/// Integral of f from a to b by `panels` panels of the Gauss-Legendre rule with 8 nodes.
template <class F>
double integrate(const F& f, double a, double b, int panels = 1) {
  constexpr std::array x{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                         0.9602898564975363};
  constexpr std::array w{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                         0.1012285362903763};
  const double half = (b - a) / (2.0 * panels);
  double sum = 0;
  for (int p = 0; p < panels; ++p) {
    const double mid = a + (2 * p + 1) * half;
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += w[i] * (f(mid - half * x[i]) + f(mid + half * x[i]));
  }
  return sum * half;
}

/// Integral of f(x, y) over the rectangle [ax,bx] x [ay,by].
template <class F>
double integrate2(const F& f, double ax, double bx, double ay, double by, int panels = 1) {
  return integrate(
      [&](double x) { return integrate([&](double y) { return f(x, y); }, ay, by, panels); }, ax,
      bx, panels);
}

}  // namespace raytracing
