#include <cmath>

#include "direct_methods.h"

namespace raytracing {
namespace {

// f(wo,wi) cos_x cos_light / r^2 for the point q of the light, without visibility: the integrand
// over the light's area, Le left out.
Rgb unoccluded_integrand(const DirectQuery& query, const Vec3& q) {
  const Vec3 d = q - query.vertex.position;
  const float distance2 = dot(d, d);
  const float height = -dot(d, query.light.normal);
  if (height <= 0) return Rgb(0.0f);
  const float distance = std::sqrt(distance2);
  return reflected(query.vertex, d / distance) * (height / (distance2 * distance));
}

}  // namespace

// The report's estimator. It multiplies the integrand at ONE random point of a chord by the visible
// fraction of the chord, estimated by other rays. The mean of a product is not the product of the
// means: where both vary along the chord, it is biased (Billen & Dutré 2016 integrate instead).
Rgb estimate_line_ratio(const DirectQuery& query, Visibility& visibility) {
  const ChordSet& chords = query.light.chords[0];
  const std::optional<Chord> chord = chords.at(query.u.x * chords.extent());
  if (!chord) return Rgb(0.0f);
  const Rgb at_one_point = unoccluded_integrand(query, chord->at(query.u.y));
  if (is_black(at_one_point)) return Rgb(0.0f);
  int visible = 0;
  for (int i = 0; i < query.line_rays; ++i) {
    const float t = query.sampler.extra(query.pair, static_cast<std::uint32_t>(i));
    if (!visibility.occluded(query.vertex, chord->at(t), query.light)) ++visible;
  }
  const float fraction = static_cast<float>(visible) / static_cast<float>(query.line_rays);
  return query.light.Le * at_one_point * (chords.extent() * chord->length * fraction);
}

}  // namespace raytracing
