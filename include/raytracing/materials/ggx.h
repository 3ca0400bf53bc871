#pragma once

#include <cmath>
#include <optional>

#include "raytracing/materials/bsdf_sample.h"
#include "raytracing/math/numeric.h"

namespace raytracing {

/// How the reflectance of a conductor depends on the angle between half vector and direction.
enum class Fresnel {
  none,     ///< constant: the reflectance at every angle
  schlick,  ///< Schlick 1994, eq. 15, with the reflectance at normal incidence
};

/// Rough conductor with the GGX distribution of microfacets (Walter et al. 2007), height-correlated
/// Smith masking and shadowing (Heitz 2014, eq. 99), single scattering.
struct GgxConductor {
  static constexpr bool kLambertian = false;
  /// A narrow lobe finds the lights that fill it better than light sampling does.
  static constexpr bool kWantsMis = true;

  Rgb reflectance{0.9f};  ///< each in [0,1]
  float alpha = 0.16f;    ///< roughness squared, in (0,1]
  Fresnel fresnel = Fresnel::none;
};

/// The formulas of GGX. They take squared sines and cosines, so that they serve local frames and
/// loops over many surfaces in world space alike.
namespace ggx {

/// Density of microfacet normals per steradian and projected area (Walter et al. 2007, eq. 33), in
/// a form that stays exact where the half vector is near the normal and alpha is small. `sin2_h`
/// and `cos2_h` belong to the angle between half vector and normal.
inline float distribution(float alpha, float sin2_h, float cos2_h) {
  return 1 / (kPi * square(alpha * (sin2_h / square(alpha) + cos2_h)));
}

/// Length of a unit direction stretched by the roughness, |(alpha x, alpha y, z)|: Smith's Lambda
/// is (stretched / z - 1) / 2.
inline float stretched(float alpha, float sin2, float cos2) {
  return std::sqrt(square(alpha) * sin2 + cos2);
}

/// f cos_i without the reflectance: D G2 / (4 cos_o), with the height-correlated G2 = 2 cos_o cos_i
/// / (cos_i |wo stretched| + cos_o |wi stretched|), so that cos_o cancels.
inline float value(float distribution, float cos_o, float cos_i, float stretched_o,
                   float stretched_i) {
  return distribution * (0.5f / (cos_i * stretched_o + cos_o * stretched_i)) * cos_i;
}

/// Density of wi per steradian: that of the visible normals, times the Jacobian 1 / (4 wo.h) of the
/// reflection.
inline float pdf_w(float distribution, float cos_o, float stretched_o) {
  return distribution / (2 * (cos_o + stretched_o));
}

/// The weight of white in Schlick's reflectance at the angle with this cosine.
inline float schlick_weight(float wo_dot_h) {
  const float c = std::clamp(1 - wo_dot_h, 0.0f, 1.0f);
  return square(square(c)) * c;
}

/// The reflectance at the angle between wo and h.
inline Rgb reflectance(const GgxConductor& m, float wo_dot_h) {
  if (m.fresnel == Fresnel::none) return m.reflectance;
  return m.reflectance + (Rgb(1.0f) - m.reflectance) * schlick_weight(wo_dot_h);
}

/// `stretched` for a direction in the local frame.
inline float stretched(float alpha, const Vec3& w) {
  return stretched(alpha, w.x * w.x + w.y * w.y, w.z * w.z);
}

/// `distribution` for a half vector in the local frame.
inline float distribution(float alpha, const Vec3& h) {
  return distribution(alpha, h.x * h.x + h.y * h.y, h.z * h.z);
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

inline Rgb eval_cos(const GgxConductor& m, const Vec3& wo, const Vec3& wi) {
  if (wi.z <= 0 || wo.z <= 0) return Rgb(0.0f);
  const Vec3 h = normalize(wo + wi);
  return ggx::reflectance(m, dot(wo, h)) * ggx::value(ggx::distribution(m.alpha, h), wo.z, wi.z,
                                                      ggx::stretched(m.alpha, wo),
                                                      ggx::stretched(m.alpha, wi));
}

inline float bsdf_pdf_w(const GgxConductor& m, const Vec3& wo, const Vec3& wi) {
  if (wi.z <= 0 || wo.z <= 0) return 0;
  const Vec3 h = normalize(wo + wi);
  return ggx::pdf_w(ggx::distribution(m.alpha, h), wo.z, ggx::stretched(m.alpha, wo));
}

inline std::optional<BsdfSample> sample_bsdf(const GgxConductor& m, const Vec3& wo, const Vec2& u) {
  const Vec3 h = ggx::sample_visible_normal(m.alpha, wo, u);
  const float wo_dot_h = dot(wo, h);
  const Vec3 wi = 2 * wo_dot_h * h - wo;
  if (!(wi.z > 0)) return std::nullopt;
  const float so = ggx::stretched(m.alpha, wo);
  const float si = ggx::stretched(m.alpha, wi);
  const float pdf_w = ggx::pdf_w(ggx::distribution(m.alpha, h), wo.z, so);
  if (!(pdf_w > 0)) return std::nullopt;
  const float masking = wi.z * (wo.z + so) / (wi.z * so + wo.z * si);
  return BsdfSample{wi, ggx::reflectance(m, wo_dot_h) * masking, pdf_w};
}

inline LobeShape lobe_shape(const GgxConductor& m) {
  return LobeShape::ggx(m.reflectance, m.alpha, m.fresnel == Fresnel::schlick);
}

}  // namespace raytracing
