#pragma once
// Reflection in the local frame of a surface: z is the shading normal, on the side of the viewer.
// wo points to the viewer, wi to where light comes from; both leave the surface, wo.z > 0.
// `eval_cos` is f(wo,wi) times |cos wi|; `pdf_w` is a density per steradian of wi.

#include "raytracing/math/vec.h"

namespace raytracing {

struct BsdfSample {
  Vec3 wi;
  Rgb weight;   ///< eval_cos / pdf_w
  float pdf_w;  ///< > 0
};

/// A material in plain numbers, for loops over many surfaces that must not branch. Its lobe is
/// that of GGX or, with `ggx` = 0, the cosine lobe.
struct LobeShape {
  Rgb reflectance{0.0f};  ///< at normal incidence
  float ggx = 0;          ///< 1 = GGX, 0 = Lambertian
  float alpha = 1;        ///< roughness squared, in (0,1]
  float schlick = 0;      ///< 1 = the reflectance follows Schlick's formula, 0 = it is constant
};

}  // namespace raytracing
