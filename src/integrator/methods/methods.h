#pragma once
// The declarations of the methods, made from the table: a method's own file defines the function of
// its name, which returns its row.

#include "raytracing/integrator/direct_method.h"

namespace raytracing::methods {

#define METHOD(name) DirectMethod name();
#include "table.inc"
#undef METHOD

/// The density per steradian, as seen from the vertex, of points that are uniform in the area of
/// the light: the DirectMethod::pdf_w of the methods that choose them so.
inline float uniform_in_area_pdf_w(const AreaLight& light, const Vertex& from, const Vec3& q) {
  return area_pdf_w(light, from.position, q);
}

}  // namespace raytracing::methods
