// point-2: the average of two random points of the light. The example of src/README.md; the test
// cli_new_method_test adds it to the table and looks for it in help, pictures, chart and stress.

#include "methods.h"

namespace raytracing::methods {
namespace {

void estimate(const DirectQuery& query, RayQueries&, DirectEstimate& estimate) {
  const Vec2 second{query.sampler.extra(query.pair, 0), query.sampler.extra(query.pair, 1)};
  for (const Vec2& u : {query.u, second}) {
    const Vec3 q = sample_area(query.light, u);
    estimate.add_point(q, uniform_in_area_pdf_w(query.light, query.vertex, q), 0.5f);
  }
}

}  // namespace

DirectMethod point_2() {
  return {.name = "point-2",
          .summary = "the average of two points of the light, uniform in area",
          .cost = "2 shadow rays",
          .unbiased = true,
          .colour = "#009e73",
          .mark = 11,
          .estimate = estimate,
          .pdf_w = uniform_in_area_pdf_w};
}

}  // namespace raytracing::methods
