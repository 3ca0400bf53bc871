// line-rays: stratified points on one chord of the light, each with its own shadow ray.
//
// The unbiased repair of line-ratio: a chord chosen with a density proportional to its length, and
// the average of integrand times visibility over --line-rays stratified points of it.
//
// Its error falls like that of random points, N^-1, since the position along the chord is random.

#include "methods.h"

namespace raytracing::methods {
namespace {

void estimate(const DirectQuery& query, RayQueries&, DirectEstimate& estimate) {
  const ChordSet& chords = query.light.chords[0];
  const std::optional<Chord> chord = chords.at(chords.u_of_area(query.u.x));
  if (!chord) return;
  const float share = 1 / static_cast<float>(query.line_rays);
  for (int i = 0; i < query.line_rays; ++i) {
    const float jitter = query.sampler.extra(query.pair, static_cast<std::uint32_t>(i));
    const float t = (static_cast<float>(i) + jitter) / static_cast<float>(query.line_rays);
    const Vec3 q = chord->at(t);
    estimate.add_point(q, uniform_in_area_pdf_w(query.light, query.vertex, q), share);
  }
}

}  // namespace

DirectMethod line_rays() {
  return {.name = "line-rays",
          .summary = "one chord of the light, average over --line-rays stratified points on it",
          .cost = "--line-rays shadow rays",
          .unbiased = true,
          .colour = "#56b4e9",
          .mark = 13,
          .estimate = estimate,
          .pdf_w = uniform_in_area_pdf_w};
}

}  // namespace raytracing::methods
