#pragma once
// Materials in world space and without branches, for loops over many surfaces.

#include <cmath>

#include "raytracing/materials/ggx.h"

namespace raytracing {

/// The reflection of light from one direction. f cos is `value` times the reflectance, in which
/// white has the weight `schlick`: see with_white().
struct Lobe {
  float pdf_w;  ///< as bsdf_pdf_w
  float value;
  float schlick;
};

/// Returns the reflectance, in which white has this weight.
inline float with_white(float reflectance, float white) {
  return reflectance + (1 - reflectance) * white;
}

/// The cosine lobe, for a cosine of wi above 0.
inline Lobe lambertian_lobe(float cos_i) { return {cos_i * kInvPi, cos_i * kInvPi, 0}; }

/// Returns the lobe of a material around the unit shading normal n for the unit directions wo and
/// wi above its horizon, all in world space. `is_ggx`, `alpha` and `schlick` are those of its
/// LobeShape. Both kinds of lobe are computed and one is chosen, without branches.
inline Lobe lobe(float is_ggx, float alpha, float schlick, const Vec3& n, const Vec3& wo,
                 const Vec3& wi) {
  const float cos_o = dot(n, wo), cos_i = dot(n, wi);
  const Vec3 sum = wo + wi, turned = cross(n, sum);
  const float length2 = dot(sum, sum), scale = 1 / length2;
  const float distribution =
      ggx::distribution(alpha, scale * dot(turned, turned), scale * square(dot(n, sum)));
  const float stretched_o = ggx::stretched(alpha, 1 - square(cos_o), square(cos_o));
  const float stretched_i = ggx::stretched(alpha, 1 - square(cos_i), square(cos_i));
  const bool ggx = is_ggx > 0;
  const Lobe cosine = lambertian_lobe(cos_i);
  return {ggx ? ggx::pdf_w(distribution, cos_o, stretched_o) : cosine.pdf_w,
          ggx ? ggx::value(distribution, cos_o, cos_i, stretched_o, stretched_i) : cosine.value,
          schlick * ggx::schlick_weight(std::sqrt(length2) / 2)};
}

}  // namespace raytracing
