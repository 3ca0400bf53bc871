#include <cmath>

#include "direct_methods.h"

namespace raytracing {
namespace {

// Le f cos / pdf_w for one point q of the light, with the MIS weight.
Rgb estimate_from(const DirectQuery& query, Visibility& visibility, const Vec3& q, float pdf_w) {
  // The density is infinite for a vertex in the light's own plane, to which it sends nothing.
  if (!(pdf_w > 0 && std::isfinite(pdf_w))) return Rgb(0.0f);
  const Vec3 wi = normalize(q - query.vertex.position);
  const Rgb f_cos = reflected(query.vertex, wi);
  if (is_black(f_cos) || visibility.occluded(query.vertex, q, query.light)) return Rgb(0.0f);
  return query.light.Le * f_cos * (light_sample_weight(query, wi, pdf_w) / pdf_w);
}

}  // namespace

Rgb estimate_point(const DirectQuery& query, Visibility& visibility) {
  const Vec3 q = sample_area(query.light, query.u);
  return estimate_from(query, visibility, q, area_pdf_w(query.light, query.vertex.position, q));
}

Rgb estimate_solid_angle(const DirectQuery& query, Visibility& visibility) {
  const auto sample = sample_solid_angle(query.light, query.vertex.position, query.u);
  if (!sample) return Rgb(0.0f);
  return estimate_from(query, visibility, sample->point, sample->pdf_w);
}

}  // namespace raytracing
