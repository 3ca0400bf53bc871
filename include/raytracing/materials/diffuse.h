#pragma once

#include <optional>

#include "raytracing/materials/bsdf_sample.h"
#include "raytracing/sampling/warp.h"

namespace raytracing {

/// Lambert's reflector: f = reflectance / pi.
struct Diffuse {
  static constexpr bool kLambertian = true;
  /// Light sampling is left alone: the lobe is wider than any light.
  static constexpr bool kWantsMis = false;

  Rgb reflectance{0.5f};  ///< each in [0,1]
};

inline Rgb eval_cos(const Diffuse& diffuse, const Vec3& /*wo*/, const Vec3& wi) {
  return diffuse.reflectance * cosine_hemisphere_pdf_w(wi.z);
}

inline float bsdf_pdf_w(const Diffuse&, const Vec3& /*wo*/, const Vec3& wi) {
  return cosine_hemisphere_pdf_w(wi.z);
}

inline std::optional<BsdfSample> sample_bsdf(const Diffuse& diffuse, const Vec3& /*wo*/,
                                             const Vec2& u) {
  const Vec3 wi = square_to_cosine_hemisphere(u);
  if (wi.z <= 0) return std::nullopt;
  return BsdfSample{wi, diffuse.reflectance, cosine_hemisphere_pdf_w(wi.z)};
}

inline LobeShape lobe_shape(const Diffuse& diffuse) {
  return LobeShape::lambertian(diffuse.reflectance);
}

}  // namespace raytracing
