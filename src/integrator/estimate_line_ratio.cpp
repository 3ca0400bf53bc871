#include <cmath>

#include "direct_methods.h"

namespace raytracing {
namespace {

// f(wo,wi) cos_x cos_light / r^2 for a point q of the light, without visibility: the integrand over
// the light's area, Le left out.
struct Unoccluded {
  Vec3 wi{0.0f};
  float geometry = 0;  // cos_light / r^2
  Rgb value{0.0f};

  Unoccluded(const DirectQuery& query, const Vec3& q) {
    const Vec3 d = q - query.vertex.position;
    const float distance2 = dot(d, d);
    const float height = -dot(d, query.light.normal);
    if (height <= 0) return;
    const float distance = std::sqrt(distance2);
    wi = d / distance;
    geometry = height / (distance2 * distance);
    value = reflected(query.vertex, wi) * geometry;
  }
};

}  // namespace

// The report's estimator. It multiplies the integrand at ONE random point of a chord by the visible
// fraction of the chord, estimated by other rays. The mean of a product is not the product of the
// means: where both vary along the chord, it is biased (Billen & Dutré 2016 integrate instead).
Rgb estimate_line_ratio(const DirectQuery& query, Visibility& visibility) {
  const ChordSet& chords = query.light.chords[0];
  const std::optional<Chord> chord = chords.at(query.u.x * chords.extent());
  if (!chord) return Rgb(0.0f);
  const Unoccluded at_one_point(query, chord->at(query.u.y));
  if (is_black(at_one_point.value)) return Rgb(0.0f);
  int visible = 0;
  for (int i = 0; i < query.line_rays; ++i) {
    const float t = query.sampler.extra(query.pair, static_cast<std::uint32_t>(i));
    if (!visibility.occluded(query.vertex, chord->at(t), query.light)) ++visible;
  }
  const float fraction = static_cast<float>(visible) / static_cast<float>(query.line_rays);
  const float measure = chords.extent() * chord->length * fraction;
  if (query.directions != nullptr)
    query.directions->push_back(
        {at_one_point.wi, query.light.Le * (at_one_point.geometry * measure), 0});
  return query.light.Le * at_one_point.value * measure;
}

}  // namespace raytracing
