#pragma once
// The methods; those alike share a source file. Only the table and the methods themselves include
// this.

#include <cmath>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/materials/bsdf.h"
#include "raytracing/sampling/mis.h"

namespace raytracing {

Rgb estimate_point(const DirectQuery& query, Visibility& visibility);

Rgb estimate_solid_angle(const DirectQuery& query, Visibility& visibility);

Rgb estimate_line_ratio(const DirectQuery& query, Visibility& visibility);

Rgb estimate_line_rays(const DirectQuery& query, Visibility& visibility);

Rgb estimate_line(const DirectQuery& query, Visibility& visibility);

/// f(wo,wi) |cos wi| of the vertex for the direction wi (world, unit); black below either horizon.
inline Rgb reflected(const Vertex& vertex, const Vec3& wi) {
  if (dot(wi, vertex.ng) <= 0) return Rgb(0.0f);
  return eval_cos(*vertex.material, vertex.wo, vertex.shading.to_local(wi));
}

/// The weight of a light sample in the direction `wi` (world, unit) with density `pdf_w`, against
/// BSDF sampling of the same light (balance heuristic); 1 where the material does without.
inline float light_sample_weight(const DirectQuery& query, const Vec3& wi, float pdf_w) {
  const Vertex& v = query.vertex;
  if (!wants_mis(*v.material)) return 1;
  const float bsdf = bsdf_pdf_w(*v.material, v.wo, v.shading.to_local(wi));
  return balance_heuristic(query.light_pmf * pdf_w, bsdf);
}

/// Le f cos `visible` / pdf_w for the direction `wi` (world, unit) of reflectance `f_cos`, times
/// its weight against BSDF sampling.
inline Rgb one_direction(const DirectQuery& query, const Vec3& wi, const Rgb& f_cos, float visible,
                         float pdf_w) {
  if (query.directions != nullptr)
    query.directions->push_back({wi, query.light.Le * (visible / pdf_w), query.light_pmf * pdf_w});
  return query.light.Le * f_cos * (visible * light_sample_weight(query, wi, pdf_w) / pdf_w);
}

/// Le f cos / pdf_w for one point `q` of the light that was chosen with the density `pdf_w` per
/// steradian, times its visibility and its weight against BSDF sampling.
inline Rgb light_point(const DirectQuery& query, Visibility& visibility, const Vec3& q,
                       float pdf_w) {
  // The density is infinite for a vertex in the light's own plane, to which it sends nothing.
  if (!(pdf_w > 0 && std::isfinite(pdf_w))) return Rgb(0.0f);
  const Vec3 wi = normalize(q - query.vertex.position);
  const Rgb f_cos = reflected(query.vertex, wi);
  if (is_black(f_cos) || visibility.occluded(query.vertex, q, query.light)) return Rgb(0.0f);
  return one_direction(query, wi, f_cos, 1, pdf_w);
}

}  // namespace raytracing
