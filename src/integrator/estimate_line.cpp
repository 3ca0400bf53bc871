#include <cmath>

#include "direct_methods.h"
#include "raytracing/lights/chord.h"
#include "raytracing/lights/chord_integral.h"

namespace raytracing {
namespace {

// The parts of the chord that lie above the vertex's horizons and are not hidden from it.
IntervalSet visible_parts(const Vertex& v, const AreaLight& light, const Chord& chord,
                          const SeenChord& seen, Visibility& visibility) {
  const Interval above = seen.above_horizon(v.shading.z, seen.above_horizon(v.ng, Interval{0, 1}));
  if (!(above.length() > 0)) return IntervalSet(Interval{0, 0});
  return visibility.visible_part(v, chord, above, light);
}

// Exact for a diffuse surface: the reflected radiance of all visible parts.
Rgb closed_form(const DirectQuery& query, int direction, Visibility& visibility) {
  const Vertex& v = query.vertex;
  const auto sample = sample_whole_chord(query.light, v.position, direction, query.u.x);
  if (!sample) return Rgb(0.0f);
  const SeenChord seen(sample->chord, v.position, query.light.normal);
  const IntervalSet parts = visible_parts(v, query.light, sample->chord, seen, visibility);
  float irradiance = 0;
  for (const Interval& part : parts.intervals()) irradiance += seen.irradiance(v.shading.z, part);
  if (irradiance == 0) return Rgb(0.0f);
  // Along wi = normal, f cos is f itself: reflectance / pi.
  const Rgb f = reflected(v, v.shading.z);
  return query.light.Le * f * (irradiance / sample->pdf_u);
}

// For any surface: one point of the visible parts, which stand for their share of the chord. The
// weight against BSDF sampling takes the density that the point would have without occluders; any
// weights that sum to one at each point of the light keep the sum unbiased.
Rgb one_point(const DirectQuery& query, int direction, Visibility& visibility) {
  const Vertex& v = query.vertex;
  const auto sample = sample_chord(query.light, v.position, direction, query.u.x);
  if (!sample) return Rgb(0.0f);
  if (query.light.rectangle && sample->solid_angle == 0) visibility.count_area_fallback();
  const SeenChord seen(sample->chord, v.position, query.light.normal);
  const IntervalSet parts = visible_parts(v, query.light, sample->chord, seen, visibility);
  if (parts.empty()) return Rgb(0.0f);
  float visible = 0;
  for (const Interval& part : parts.intervals()) visible += sample->share(part);
  const Vec3 q = sample->chord.at(sample->parameter(parts.intervals(), query.u.y));
  const Vec3 wi = normalize(q - v.position);
  const float pdf_w =
      sample->solid_angle > 0 ? 1 / sample->solid_angle : area_pdf_w(query.light, v.position, q);
  if (!(pdf_w > 0 && std::isfinite(pdf_w))) return Rgb(0.0f);
  return one_direction(query, wi, reflected(v, wi), visible, pdf_w);
}

}  // namespace

// A random chord of the light, its exact visible parts, and the light that they reflect to the
// viewer: in closed form by a diffuse surface, by one point of the visible parts otherwise.
Rgb estimate_line(const DirectQuery& query, Visibility& visibility) {
  // Where shadow edges run along the chords of one direction, they cross those of the other. Fixed
  // for all samples of a pixel, so that these stay stratified; neighbouring pixels share the risk.
  const int direction = query.sampler.coin_of_pixel(query.pair) ? 1 : 0;
  return std::holds_alternative<Diffuse>(*query.vertex.material)
             ? closed_form(query, direction, visibility)
             : one_point(query, direction, visibility);
}

}  // namespace raytracing
