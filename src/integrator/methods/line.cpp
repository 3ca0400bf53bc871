// line: one random chord of the light and its exact visible parts.
//
// On a Lambertian surface the light of the visible parts is integrated in closed form (Billen &
// Dutré 2016). On all others one point of the visible parts stands for their share of the chord.
// One segment query to the occluder tree answers the visibility of the whole chord.
//
// Has the least noise in penumbrae, near lights and behind blinds. Where a shadow edge runs along
// the chords it gains nothing; so each pixel draws one of two chord directions. A query walks
// everything that crosses its plane: under finely tessellated occluders it costs many shadow rays.

#include "methods.h"
#include "raytracing/lights/chord_integral.h"

namespace raytracing::methods {
namespace {

// The parts of the chord that lie above both horizons of the vertex and are unoccluded.
IntervalSet visible_parts(const DirectQuery& query, const Chord& chord, const SeenChord& seen,
                          RayQueries& rays) {
  const Vertex& v = query.vertex;
  const Interval above = seen.above_horizon(v.shading.z, seen.above_horizon(v.ng, Interval{0, 1}));
  if (!(above.length() > 0)) return IntervalSet(Interval{0, 0});
  return rays.visible_part(v, chord, above, query.light);
}

// For a Lambertian surface: the irradiance of all visible parts, exact.
void add_closed_form(const DirectQuery& query, int direction, RayQueries& rays,
                     DirectEstimate& estimate) {
  const Vertex& v = query.vertex;
  const auto sample = sample_whole_chord(query.light, v.position, direction, query.u.x);
  if (!sample) return;
  const SeenChord seen(sample->chord, v.position, query.light.normal);
  const IntervalSet parts = visible_parts(query, sample->chord, seen, rays);
  float irradiance = 0;
  for (const Interval& part : parts.intervals()) irradiance += seen.irradiance(v.shading.z, part);
  estimate.add_irradiance(irradiance / sample->pdf_u);
}

// For any surface: one point of the visible parts. Its MIS weight takes the density that the point
// would have without occluders; any weights that sum to one at each point of the light keep the sum
// unbiased.
void add_one_point(const DirectQuery& query, int direction, RayQueries& rays,
                   DirectEstimate& estimate) {
  const Vertex& v = query.vertex;
  const auto sample = sample_chord(query.light, v.position, direction, query.u.x);
  if (!sample) return;
  if (query.light.rectangle && sample->solid_angle == 0) rays.count_area_fallback();
  const SeenChord seen(sample->chord, v.position, query.light.normal);
  const IntervalSet parts = visible_parts(query, sample->chord, seen, rays);
  if (parts.empty()) return;
  float visible = 0;
  for (const Interval& part : parts.intervals()) visible += sample->share(part);
  const Vec3 q = sample->chord.at(sample->parameter(parts.intervals(), query.u.y));
  const float pdf_w =
      sample->solid_angle > 0 ? 1 / sample->solid_angle : area_pdf_w(query.light, v.position, q);
  estimate.add_direction(normalize(q - v.position), pdf_w, visible);
}

float pdf_w(const AreaLight& light, const Vertex& from, const Vec3& q) {
  return chord_pdf_w(light, from.position, q);
}

void estimate(const DirectQuery& query, RayQueries& rays, DirectEstimate& estimate) {
  // The direction is the same for all samples of a pixel, so that these stay stratified;
  // neighbouring pixels share the risk of a shadow edge along the chords.
  const int direction = query.sampler.coin_of_pixel(query.pair) ? 1 : 0;
  if (is_lambertian(*query.vertex.material))
    add_closed_form(query, direction, rays, estimate);
  else
    add_one_point(query, direction, rays, estimate);
}

}  // namespace

DirectMethod line() {
  return {.name = "line",
          .summary =
              "one chord of the light, its exact visible parts; in closed form where "
              "diffuse",
          .cost = "1 segment query",
          .unbiased = true,
          .colour = "#000000",
          .mark = 9,
          .estimate = estimate,
          .pdf_w = pdf_w,
          .asks_segments = true};
}

}  // namespace raytracing::methods
