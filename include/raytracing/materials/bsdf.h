#pragma once
// Reflection in the local frame of a surface: z is the shading normal, on the side of the viewer.
// wo points to the viewer, wi to where light comes from; both leave the surface, wo.z > 0.
// `eval_cos` is f(wo,wi) times |cos wi|; `pdf_w` is per steradian of wi.

#include <optional>

#include "raytracing/materials/material.h"
#include "raytracing/math/vec.h"

namespace raytracing {

struct BsdfSample {
  Vec3 wi;
  Rgb weight;   ///< eval_cos / pdf_w
  float pdf_w;  ///< > 0
};

Rgb eval_cos(const Material& material, const Vec3& wo, const Vec3& wi);
/// Nothing when the sample points below the surface: it then carries no light.
std::optional<BsdfSample> sample_bsdf(const Material& material, const Vec3& wo, const Vec2& u);
float bsdf_pdf_w(const Material& material, const Vec3& wo, const Vec3& wi);

/// Whether light that BSDF sampling finds should share the work with light sampling. A diffuse
/// surface gains nothing from it, since its lobe is wider than any light.
inline bool wants_mis(const Material& material) {
  return !std::holds_alternative<Diffuse>(material);
}

}  // namespace raytracing
