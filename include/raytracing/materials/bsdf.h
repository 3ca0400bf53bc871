#pragma once
// What any material does; the conventions are those of bsdf_sample.h. Each function asks the kinds
// in turn: std::visit would not be inlined.

#include <optional>

#include "raytracing/materials/diffuse.h"
#include "raytracing/materials/ggx.h"
#include "raytracing/materials/material.h"

namespace raytracing {

inline Rgb eval_cos(const Material& material, const Vec3& wo, const Vec3& wi) {
  if (const auto* diffuse = std::get_if<Diffuse>(&material)) return eval_cos(*diffuse, wo, wi);
  return eval_cos(std::get<GgxConductor>(material), wo, wi);
}

/// Nothing when the sample points below the surface: it then carries no light.
inline std::optional<BsdfSample> sample_bsdf(const Material& material, const Vec3& wo,
                                             const Vec2& u) {
  if (const auto* diffuse = std::get_if<Diffuse>(&material)) return sample_bsdf(*diffuse, wo, u);
  return sample_bsdf(std::get<GgxConductor>(material), wo, u);
}

inline float bsdf_pdf_w(const Material& material, const Vec3& wo, const Vec3& wi) {
  if (const auto* diffuse = std::get_if<Diffuse>(&material)) return bsdf_pdf_w(*diffuse, wo, wi);
  return bsdf_pdf_w(std::get<GgxConductor>(material), wo, wi);
}

/// Whether light that BSDF sampling finds should share the work with light sampling. A diffuse
/// surface gains nothing from it, since its lobe is wider than any light.
inline bool wants_mis(const Material& material) {
  return !std::holds_alternative<Diffuse>(material);
}

}  // namespace raytracing
