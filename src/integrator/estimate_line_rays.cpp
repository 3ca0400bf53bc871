#include "direct_methods.h"

namespace raytracing {

// The unbiased repair of line-ratio: on a chord chosen with density proportional to its length, the
// average of integrand times visibility over stratified points, each with its own ray.
Rgb estimate_line_rays(const DirectQuery& query, Visibility& visibility) {
  const ChordSet& chords = query.light.chords[0];
  const std::optional<Chord> chord = chords.at(chords.u_of_area(query.u.x));
  if (!chord) return Rgb(0.0f);
  Rgb sum(0.0f);
  for (int i = 0; i < query.line_rays; ++i) {
    const float jitter = query.sampler.extra(query.pair, static_cast<std::uint32_t>(i));
    const float t = (static_cast<float>(i) + jitter) / static_cast<float>(query.line_rays);
    const Vec3 q = chord->at(t);
    sum += light_point(query, visibility, q, area_pdf_w(query.light, query.vertex.position, q));
  }
  if (query.directions != nullptr)
    for (LightSample& sample : *query.directions)
      sample.light /= static_cast<float>(query.line_rays);
  return sum / static_cast<float>(query.line_rays);
}

}  // namespace raytracing
