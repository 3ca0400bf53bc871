#pragma once
// Reflection in the local frame of a surface: z is the shading normal, on the side of the viewer.
// wo points to the viewer, wi to where light comes from; both leave the surface, wo.z > 0. Below
// the horizon, for wi.z <= 0, `eval_cos` and `bsdf_pdf_w` are 0. `eval_cos` is f(wo,wi) times |cos
// wi|; `pdf_w` is a density per steradian of wi.

#include "raytracing/math/vec.h"

namespace raytracing {

struct BsdfSample {
  Vec3 wi;
  Rgb weight;   ///< eval_cos / pdf_w
  float pdf_w;  ///< > 0
};

/// A material in plain numbers, for loops over many surfaces that must not branch: `lobe` in lobe.h
/// evaluates it. A material chooses its lobe by one of the two functions.
class LobeShape {
 public:
  /// The cosine lobe; `reflectance` as for Diffuse.
  static LobeShape lambertian(const Rgb& reflectance) { return {reflectance, 0, 1, 0}; }
  /// The lobe of GGX; reflectance at normal incidence and alpha as for GgxConductor. With
  /// `schlick`, the reflectance depends on the angle by Schlick's formula.
  static LobeShape ggx(const Rgb& reflectance, float alpha, bool schlick) {
    return {reflectance, 1, alpha, schlick ? 1.0f : 0.0f};
  }

  Rgb reflectance;
  float is_ggx;  ///< 1 = GGX, 0 = Lambertian
  float alpha;
  float schlick;  ///< 1 = with Schlick's formula, 0 = without

 private:
  LobeShape(const Rgb& at_normal, float ggx_or_not, float roughness, float schlick_or_not)
      : reflectance(at_normal), is_ggx(ggx_or_not), alpha(roughness), schlick(schlick_or_not) {}
};

}  // namespace raytracing
