#pragma once

#include <cmath>
#include <optional>

#include "raytracing/materials/bsdf_sample.h"
#include "raytracing/materials/material.h"
#include "raytracing/math/numeric.h"

namespace raytracing {

namespace ggx {

/// Density of microfacet normals per steradian and projected area (Walter et al. 2007, eq. 33), in
/// a form that stays exact where h is near the normal and alpha is small.
inline float distribution(float alpha, const Vec3& h) {
  const float k = (h.x * h.x + h.y * h.y) / square(alpha) + h.z * h.z;
  return 1 / (kPi * square(alpha * k));
}

/// Length of w stretched by the roughness, |(alpha x, alpha y, z)|: Smith's Lambda is
/// (stretched / z - 1) / 2.
inline float stretched(float alpha, const Vec3& w) {
  return std::sqrt(square(alpha) * (w.x * w.x + w.y * w.y) + w.z * w.z);
}

/// Schlick's weight of the white part of the reflectance at the angle whose cosine is given.
inline Rgb reflectance(const GgxConductor& m, float wo_dot_h) {
  if (m.fresnel == Fresnel::none) return m.reflectance;
  const float c = std::clamp(1 - wo_dot_h, 0.0f, 1.0f);
  return m.reflectance + (Rgb(1.0f) - m.reflectance) * (square(square(c)) * c);
}

/// A microfacet normal with density max(0, wo.h) D(h) G1(wo) / wo.z per steradian (Dupuy & Benyoub
/// 2023, listing 3: the normals visible to wo are a cap of a sphere after stretching).
inline Vec3 sample_visible_normal(float alpha, const Vec3& wo, const Vec2& u) {
  const Vec3 w = normalize(Vec3(alpha * wo.x, alpha * wo.y, wo.z));
  const float z = (1 - u.y) * (1 + w.z) - w.z;
  const float r = safe_sqrt((1 - z) * (1 + z));
  const Vec3 h = Vec3(r * circle(u.x), z) + w;
  return normalize(Vec3(alpha * h.x, alpha * h.y, h.z));
}

}  // namespace ggx

// f = F D G2 / (4 cos_o cos_i) with the height-correlated G2 = 2 cos_o cos_i /
// (cos_i |wo stretched| + cos_o |wi stretched|), so that the cosines cancel.
inline Rgb eval_cos(const GgxConductor& m, const Vec3& wo, const Vec3& wi) {
  if (wi.z <= 0 || wo.z <= 0) return Rgb(0.0f);
  const Vec3 h = normalize(wo + wi);
  const float visibility =
      0.5f / (wi.z * ggx::stretched(m.alpha, wo) + wo.z * ggx::stretched(m.alpha, wi));
  return ggx::reflectance(m, dot(wo, h)) * (ggx::distribution(m.alpha, h) * visibility * wi.z);
}

// The density of visible normals, times the Jacobian 1 / (4 wo.h) of the reflection.
inline float bsdf_pdf_w(const GgxConductor& m, const Vec3& wo, const Vec3& wi) {
  if (wi.z <= 0 || wo.z <= 0) return 0;
  const Vec3 h = normalize(wo + wi);
  return ggx::distribution(m.alpha, h) / (2 * (wo.z + ggx::stretched(m.alpha, wo)));
}

inline std::optional<BsdfSample> sample_bsdf(const GgxConductor& m, const Vec3& wo, const Vec2& u) {
  const Vec3 h = ggx::sample_visible_normal(m.alpha, wo, u);
  const float wo_dot_h = dot(wo, h);
  const Vec3 wi = 2 * wo_dot_h * h - wo;
  if (!(wi.z > 0)) return std::nullopt;
  const float so = ggx::stretched(m.alpha, wo);
  const float si = ggx::stretched(m.alpha, wi);
  const float pdf_w = ggx::distribution(m.alpha, h) / (2 * (wo.z + so));
  if (!(pdf_w > 0)) return std::nullopt;
  const float masking = wi.z * (wo.z + so) / (wi.z * so + wo.z * si);
  return BsdfSample{wi, ggx::reflectance(m, wo_dot_h) * masking, pdf_w};
}

}  // namespace raytracing
