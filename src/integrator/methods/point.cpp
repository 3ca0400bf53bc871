// point: one random point of the light, uniform in its area.
//
// The classic estimator of direct light (Cook, Porter & Carpenter 1984): Le f cos V / p with the
// density p = r^2 / (A cos_light) per steradian. It needs nothing but one shadow ray.
//
// Fails near the light, within about a tenth of its length, and at its corners: nearly all the
// light then comes from points that are hardly ever chosen.

#include "methods.h"

namespace raytracing::methods {
namespace {

void estimate(const DirectQuery& query, RayQueries&, DirectEstimate& estimate) {
  const Vec3 q = sample_area(query.light, query.u);
  estimate.add_point(q, uniform_in_area_pdf_w(query.light, query.vertex, q));
}

}  // namespace

DirectMethod point() {
  return {.name = "point",
          .summary = "one point of the light, uniform in area",
          .cost = "1 shadow ray",
          .unbiased = true,
          .colour = "#e69f00",
          .mark = 7,
          .estimate = estimate,
          .pdf_w = uniform_in_area_pdf_w};
}

}  // namespace raytracing::methods
