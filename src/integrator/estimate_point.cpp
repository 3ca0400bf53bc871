#include "direct_methods.h"

namespace raytracing {

Rgb estimate_point(const DirectQuery& query, Visibility& visibility) {
  const Vec3 q = sample_area(query.light, query.u);
  return light_point(query, visibility, q, area_pdf_w(query.light, query.vertex.position, q));
}

Rgb estimate_solid_angle(const DirectQuery& query, Visibility& visibility) {
  const auto sample = sample_solid_angle(query.light, query.vertex.position, query.u);
  if (!sample) return Rgb(0.0f);
  if (sample->by_area) visibility.count_area_fallback();
  return light_point(query, visibility, sample->point, sample->pdf_w);
}

}  // namespace raytracing
