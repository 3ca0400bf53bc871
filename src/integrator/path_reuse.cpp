// The integrand. The paths of a group have the first vertices x_1 .. x_n, which stay their own,
// with the direct light there and the emission that their bounce meets, all as in path.h. What
// differs: the vertex y that one bounce arrives at sends light to all of the group,
//
//   L_i += f_x(i) G(x_i, y) V(x_i, y) * light(y -> x_i) / D,   D = sum over k of p_k(y)
//
// where G = cos_y / r^2, f_x contains the cosine at x, and p_k(y) = p(x_k -> y) G(x_k, y) V(x_k, y)
// is the density per area with which x_k would have chosen y: the balance heuristic over all that
// could have made the path. A Lambertian y sends the same light(y) to all: what
// trace_path() finds from there. The light from a glossy y depends on the viewer, so the heuristic
// also covers the direction w in which the path goes on there, by light sampling (density p_l) and
// by the BSDF (p_b as seen from x_k), light arriving by w being L_w:
//
//   light(y -> x_i) / D = f_y(x_i, w) L_w / sum over k of p_k(y) (p_l(w) + p_b(k, w))
//
// with p_l only where both can find the light along w. Where y depends on its viewer (side of the
// surface, interpolated normal facing away), only those take part that see the same y.

#include "path_reuse.h"

#include <algorithm>

namespace raytracing {

static_assert(PathTracer::kMaxSamples == kMaxLanes && kMaxLanes == OccluderTree::kMaxTargets);

void SharedPathTracer::trace(std::span<PathSample> samples, RayQueries& rays, PathLog& log,
                             std::size_t logged) {
  const PathContext in{scene_, options_, rays};
  log.steps.clear();
  connections_.begin(samples.size());
  find_first_hits(in, samples);
  for (std::size_t k = 0; k < samples.size(); ++k)
    start(in, samples[k], k, k == logged ? log : unwanted_log_);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!second_[k]) continue;
    const Vertex& y = *second_[k];
    find_light(in, y, samples[k].sampler);
    if (terms_.empty()) continue;
    const Rgb before = connections_.gathered(logged);
    connections_.connect_to(y, k, rays);
    for (const Term& term : terms_) connections_.add(term, y);
    const Rgb light = connections_.gathered(logged) - before;
    if (!is_black(light))
      log.steps.push_back({y.position, y.ng, Rgb(0.0f), Rgb(0.0f), light, kNone, 0});
  }
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k].radiance += connections_.gathered(k);
}

// The camera rays of neighbouring pixels are coherent.
void SharedPathTracer::find_first_hits(const PathContext& in, std::span<const PathSample> samples) {
  std::array<Ray, 8> rays;
  for (std::size_t begin = 0; begin < samples.size(); begin += 8) {
    const std::size_t n = std::min<std::size_t>(8, samples.size() - begin);
    for (std::size_t i = 0; i < n; ++i) rays[i] = samples[begin + i].ray;
    in.rays.closest_hits8(std::span(rays).first(n), &first_hits_[begin]);
  }
}

// What the sample carries to the viewer without sharing, and the vertex at which its bounce
// arrives.
void SharedPathTracer::start(const PathContext& in, PathSample& sample, std::size_t k,
                             PathLog& log) {
  log.steps.clear();
  sample.radiance = sample.direct = Rgb(0.0f);
  second_[k].reset();
  if (!first_hits_[k]) return;
  PathState path(sample.sampler, log);
  begin_at_camera(in, path, sample, *first_hits_[k]);
  connections_.set_first(k, path.vertex());
  add_direct_light(in, path);
  if (bounce(in, path)) {
    second_[k] = path.vertex();
    if (is_black(log.steps.back().emitted)) log.steps.pop_back();
  }
  sample.radiance = sample.direct = path.radiance;
}

// The light that leaves y. From a Lambertian y it is the same for all viewers.
void SharedPathTracer::find_light(const PathContext& in, const Vertex& y, PathSampler& sampler) {
  terms_.clear();
  if (is_lambertian(*y.material)) {
    PathState path(sampler, unwanted_log_);
    path.begin(y, 1);
    trace_path(in, path);
    terms_.push_back({.light = path.radiance});
  } else {
    find_light_samples(in, y, sampler);
    follow_bounce(in, y, sampler);
  }
  std::erase_if(terms_, [](const Term& term) { return is_black(term.light); });
}

// The directions by which the direct-light method finds light at y.
void SharedPathTracer::find_light_samples(const PathContext& in, const Vertex& y,
                                          PathSampler& sampler) {
  direct_light(in, y, 1, sampler, &light_samples_);
  const bool uses_mis = options_.method->uses_mis(*y.material);
  for (const LightSample& s : light_samples_)
    terms_.push_back(uses_mis ? Term{s.wi, s.light * s.light_pdf_w, s.light_pdf_w, 1}
                              : Term{s.wi, s.light, 1, 0});
}

// The direction in which the path goes on from y, and what it finds there.
void SharedPathTracer::follow_bounce(const PathContext& in, const Vertex& y, PathSampler& sampler) {
  const bool uses_mis = options_.method->uses_mis(*y.material);
  if (options_.max_depth == 2u && !uses_mis) return;
  PathState path(sampler, unwanted_log_);
  path.begin(y, 1);
  const std::optional<Scattered> scattered = scatter(path);
  if (!scattered || !advance(in, path, scattered->wi)) return;
  const std::uint32_t light = path.vertex().light;
  if (uses_mis && light != kNone)
    terms_.push_back({scattered->wi, scene_.lights()[light].Le, light_pdf_w(in, path), 1});
  trace_path(in, path);
  terms_.push_back({scattered->wi, path.radiance, 0, 1});
}

}  // namespace raytracing
