#pragma once
// The GGX conductor in double precision, from the formulas of Walter et al. 2007 and Heitz 2014,
// and coordinates of its half vectors that resolve a lobe of any width.

#include <cmath>
#include <numbers>

#include "raytracing/math/vec.h"

namespace raytracing {

/// D(h) by the angle: alpha^2 / (pi cos^4 (alpha^2 + tan^2)^2) (Walter et al. 2007, eq. 33).
inline double reference_distribution(double alpha, const DVec3& h) {
  const double tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z), a2 = alpha * alpha;
  return a2 / (std::numbers::pi * std::pow(h.z, 4) * (a2 + tan2) * (a2 + tan2));
}

/// Smith's Lambda (Heitz 2014, eq. 72).
inline double reference_lambda(double alpha, const DVec3& w) {
  const double tan2 = (w.x * w.x + w.y * w.y) / (w.z * w.z);
  return (std::sqrt(1 + alpha * alpha * tan2) - 1) / 2;
}

/// D G2 / (4 cos_o cos_i) with G2 = 1 / (1 + Lambda_o + Lambda_i) (Heitz 2014, eqs. 15 and 99).
inline double reference_f(double alpha, const DVec3& wo, const DVec3& wi) {
  const DVec3 h = normalize(wo + wi);
  return reference_distribution(alpha, h) /
         (1 + reference_lambda(alpha, wo) + reference_lambda(alpha, wi)) / (4 * wo.z * wi.z);
}

/// Coordinates of a half vector in the unit square: s = 1 / sqrt(1 + r^2) of the slope alpha r, and
/// the azimuth in turns. Integrals over microfacets are smooth in them for every alpha.
struct HalfVector {
  double s, turn;

  static HalfVector of(double alpha, const DVec3& h) {
    const double r2 = (h.x * h.x + h.y * h.y) / (h.z * h.z * alpha * alpha);
    return {1 / std::sqrt(1 + r2), std::atan2(h.y, h.x) / (2 * std::numbers::pi) + 0.5};
  }
  double slope(double alpha) const { return alpha * std::sqrt(1 - s * s) / s; }
  DVec3 direction(double alpha) const {
    const double phi = 2 * std::numbers::pi * (turn - 0.5);
    return normalize(DVec3(slope(alpha) * std::cos(phi), slope(alpha) * std::sin(phi), 1.0));
  }
  /// Solid angle of h per unit of the square: cos^3 slope d slope d phi.
  double solid_angle(double alpha) const {
    const double cosine = 1 / std::sqrt(1 + slope(alpha) * slope(alpha));
    return 2 * std::numbers::pi * alpha * alpha * std::pow(cosine / s, 3);
  }
};

}  // namespace raytracing
