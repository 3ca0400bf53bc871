#pragma once
// The methods, one source file each. Only the table and the methods themselves include this.

#include "raytracing/integrator/direct_method.h"

namespace raytracing {

Rgb estimate_point(const DirectQuery& query, Visibility& visibility);

Rgb estimate_solid_angle(const DirectQuery& query, Visibility& visibility);

Rgb estimate_line_ratio(const DirectQuery& query, Visibility& visibility);

Rgb estimate_line_rays(const DirectQuery& query, Visibility& visibility);

Rgb estimate_line(const DirectQuery& query, Visibility& visibility);

/// f(wo,wi) |cos wi| of the vertex for the direction wi (world, unit); black below either horizon.
Rgb reflected(const Vertex& vertex, const Vec3& wi);

/// The weight of a light sample in the direction `wi` (world, unit) with density `pdf_w`, against
/// BSDF sampling of the same light (balance heuristic); 1 where the material does without.
float light_sample_weight(const DirectQuery& query, const Vec3& wi, float pdf_w);

/// Le f cos `visible` / pdf_w for the direction `wi` (world, unit) of reflectance `f_cos`, times
/// its weight against BSDF sampling.
Rgb one_direction(const DirectQuery& query, const Vec3& wi, const Rgb& f_cos, float visible,
                  float pdf_w);

/// Le f cos / pdf_w for one point `q` of the light that was chosen with the density `pdf_w` per
/// steradian, times its visibility and its weight against BSDF sampling.
Rgb light_point(const DirectQuery& query, Visibility& visibility, const Vec3& q, float pdf_w);

}  // namespace raytracing
