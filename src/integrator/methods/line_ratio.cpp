// line-ratio: the estimator of the student report that this program grew from. Biased.
//
// It takes a random chord of the light, evaluates the integrand at ONE random point of it, and
// multiplies by the fraction of --line-rays other rays to the chord that arrive. The mean of a
// product is not the product of the means: where integrand and visibility both vary along the
// chord, it is biased (Billen & Dutré 2016 integrate the product instead).
//
// Fails in penumbrae and on glossy surfaces, and more samples do not help. It has no density, so
// that BSDF sampling cannot share the work.

#include "methods.h"

namespace raytracing::methods {
namespace {

void estimate(const DirectQuery& query, RayQueries& rays, DirectEstimate& estimate) {
  const ChordSet& chords = query.light.chords[0];
  const std::optional<Chord> chord = chords.at(query.u.x * chords.extent());
  if (!chord) return;
  const Vec3 d = chord->at(query.u.y) - query.vertex.position;
  const float distance2 = dot(d, d), distance = std::sqrt(distance2);
  const float height = -dot(d, query.light.normal);
  const Vec3 wi = d / distance;
  if (height <= 0 || is_black(reflected(query.vertex, wi))) return;
  int arrived = 0;
  for (int i = 0; i < query.line_rays; ++i) {
    const float t = query.sampler.extra(query.pair, static_cast<std::uint32_t>(i));
    if (!rays.occluded(query.vertex, chord->at(t), query.light)) ++arrived;
  }
  if (arrived == 0) return;
  const float pdf_a = 1 / (chords.extent() * chord->length);
  const float fraction = static_cast<float>(arrived) / static_cast<float>(query.line_rays);
  estimate.add_direction(wi, pdf_a * (distance2 * distance / height), fraction);
}

}  // namespace

DirectMethod line_ratio() {
  return {.name = "line-ratio",
          .summary =
              "one chord of the light, one random point on it, times the fraction of "
              "--line-rays rays to the chord that arrive",
          .cost = "--line-rays shadow rays",
          .unbiased = false,
          .colour = "#cc79a7",
          .mark = 8,
          .estimate = estimate};
}

}  // namespace raytracing::methods
