// solid-angle: one random point of the light, uniform in the solid angle that the light fills.
//
// Rectangles are sampled as spherical rectangles (Ureña, Fajardo & King 2013), other polygons by
// the spherical triangles of their fan (Arvo 1995). The distance and the cosine at the light leave
// the estimate; what is left is f cos V times the solid angle.
//
// Holds as near as 1e-4 lengths of the light. Fails behind many thin occluders, as every method of
// single points does, and it costs more time than `point` where the light is small and far away.
// Where the solid angle is too small or too large for float arithmetic, points are uniform in area,
// and counted as area fallbacks.

#include "methods.h"

namespace raytracing::methods {
namespace {

float pdf_w(const AreaLight& light, const Vertex& from, const Vec3& q) {
  return solid_angle_pdf_w(light, from.position, q);
}

void estimate(const DirectQuery& query, RayQueries& rays, DirectEstimate& estimate) {
  const auto sample = sample_solid_angle(query.light, query.vertex.position, query.u);
  if (!sample) return;
  if (sample->by_area) rays.count_area_fallback();
  estimate.add_point(sample->point, sample->pdf_w);
}

}  // namespace

DirectMethod solid_angle() {
  return {.name = "solid-angle",
          .summary = "one point of the light, uniform in the solid angle it fills",
          .cost = "1 shadow ray",
          .unbiased = true,
          .colour = "#d55e00",
          .mark = 5,
          .estimate = estimate,
          .pdf_w = pdf_w};
}

}  // namespace raytracing::methods
