#pragma once
// Reflection in the local frame of a surface: z is the shading normal, on the side of the viewer.
// wo points to the viewer, wi to where light comes from; both leave the surface, wo.z > 0.
// `eval_cos` is f(wo,wi) times |cos wi|; `pdf_w` is per steradian of wi.

#include "raytracing/math/vec.h"

namespace raytracing {

struct BsdfSample {
  Vec3 wi;
  Rgb weight;   ///< eval_cos / pdf_w
  float pdf_w;  ///< > 0
};

}  // namespace raytracing
