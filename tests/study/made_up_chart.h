#pragma once

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "raytracing/study/chart/summary.h"

namespace raytracing {

/// Points of a method whose relMSE is scale * spp^slope (times a lognormal factor), taking
/// `seconds` per sample, with nothing known of the bias.
inline MethodSummary made_up_method(const char* name, double scale, double slope, double seconds,
                                    double sigma, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> noise(0, sigma);
  MethodSummary method;
  method.method = &direct_method(name);
  for (int power = 0; power < 7; ++power) {
    const double spp = std::exp2(power);
    std::vector<double> errors;
    for (int i = 0; i < 8; ++i)
      errors.push_back(scale * std::pow(spp, slope) * std::exp(noise(engine)));
    ChartPoint point{};
    point.spp = std::uint64_t{1} << power;
    point.seeds = 8;
    point.seconds = {seconds * spp, 0.9 * seconds * spp, 1.2 * seconds * spp};
    point.relmse = point.relmse_corrected = spread(errors);
    method.points.push_back(point);
  }
  return method;
}

/// `slow` falls faster, but costs more.
inline ChartSummary made_up_chart(std::optional<NoiseFloor> floor, double sigma = 0) {
  std::vector<MethodSummary> methods;
  methods.push_back(made_up_method("point", 0.1, -1, 0.01, sigma, 1));
  methods.push_back(made_up_method("line", 0.2, -1.5, 0.02, sigma, 2));
  return summarise(std::move(methods), floor);
}

}  // namespace raytracing
