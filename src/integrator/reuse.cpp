// The integrand. The paths of a group have the first vertices x_1 .. x_n, which stay their own,
// with the direct light there and the emission that their bounce meets, all as in shade(). What
// differs: the vertex y that one bounce arrives at sends light to all of the group,
//
//   L_i += f_x(i) G(x_i, y) V(x_i, y) * light(y -> x_i) / D,   D = sum over k of p_k(y)
//
// where G = cos_y / r^2, f_x contains the cosine at x, and p_k(y) = p(x_k -> y) G(x_k, y) V(x_k, y)
// is the density per area with which x_k would have chosen y: the balance heuristic over all that
// could have made the path. A diffuse y sends the same light(y) to all: shade()'s walk from there.
// The light from a glossy y depends on the viewer, so the heuristic also covers the direction w in
// which the path goes on there, by light sampling (density p_l) and by the BSDF (p_b as seen from
// x_k), light arriving by w being L_w:
//
//   light(y -> x_i) / D = f_y(x_i, w) L_w / sum over k of p_k(y) (p_l(w) + p_b(k, w))
//
// with p_l only where the light along w can be found by both. Where y hangs on its viewer (side of
// the surface, interpolated normal facing away), only those take part that see the same y.

#include "raytracing/integrator/reuse.h"

#include <algorithm>
#include <array>

#include "group_views.h"
#include "path_steps.h"
#include "raytracing/materials/bsdf.h"

namespace raytracing {

static_assert(PathGroup::kMaxPaths == kMaxLanes && kMaxLanes == OccluderTree::kMaxTargets);

struct PathGroup::Scratch {
  std::array<std::optional<Hit>, kMaxPaths> hits;  // of the camera rays
  GroupViews views;
  std::vector<Term> terms;
  std::vector<LightSample> directions;
  PathLog walk_log;
};

namespace {

// The camera rays of neighbouring pixels run much alike.
void first_hits(std::span<const SharedPath> paths, Visibility& visibility,
                std::span<std::optional<Hit>> hits) {
  std::array<Ray, 8> rays;
  for (std::size_t begin = 0; begin < paths.size(); begin += 8) {
    const std::size_t n = std::min<std::size_t>(8, paths.size() - begin);
    for (std::size_t i = 0; i < n; ++i) rays[i] = paths[begin + i].ray;
    visibility.closest_hits8(std::span(rays).first(n), &hits[begin]);
  }
}

// One vertex and its bounce, as shade() has them; what they carry to the viewer without sharing.
// Returns the first vertex, which is at `hit`, or nothing where the camera ray meets none.
std::optional<Vertex> start(const Scene& scene, const ShadeOptions& options,
                            const std::optional<Hit>& hit, SharedPath& path, Visibility& visibility,
                            PathLog& log) {
  log.steps.clear();
  path.radiance = Rgb(0.0f);
  path.second.reset();
  if (!hit) return std::nullopt;
  const Vertex x = scene.vertex(path.ray, *hit);
  const Rgb emitted = emission(scene, *options.method, x, nullptr);
  const Rgb direct = direct_light(scene, options, x, 0, path.sampler, visibility);
  path.radiance = emitted + direct;
  log.steps.push_back({x.position, x.ng, Rgb(1.0f), emitted, direct, x.light, 0});

  const auto scattered = scatter(x, 0, path.sampler);
  if (!scattered) return x;
  const Ray ray{x.ray_origin(), scattered->wi};
  const std::optional<Hit> next = hit_of_bounce(ray, visibility);
  if (!next) return x;
  log.steps.back().survival = 1;
  path.second = scene.vertex(ray, *next);
  const Bounce bounce{x.position, scattered->pdf_w, options.method->uses_mis(*x.material)};
  const Rgb met = scattered->weight * emission(scene, *options.method, *path.second, &bounce);
  path.radiance += met;
  if (!is_black(met))
    log.steps.push_back({path.second->position, path.second->ng, scattered->weight, met, Rgb(0.0f),
                         path.second->light, 0});
  return x;
}

// The light samples of a glossy second vertex, and the bounce that its owner makes there.
void glossy_terms(const Scene& scene, const ShadeOptions& options, SharedPath& path,
                  Visibility& visibility, std::vector<LightSample>& directions, PathLog& log,
                  std::vector<Term>& terms) {
  const Vertex& y = *path.second;
  terms.clear();
  direct_light(scene, options, y, 1, path.sampler, visibility, &directions);
  const bool counted = options.method->uses_mis(*y.material);
  for (const LightSample& s : directions)
    terms.push_back(counted ? Term{s.wi, s.light * s.pdf_w, s.pdf_w, 1}
                            : Term{s.wi, s.light, 1, 0});
  if (options.max_depth == 2u && !counted) return;
  const auto scattered = scatter(y, 1, path.sampler);
  if (!scattered) return;
  const Vec3 wi = scattered->wi;
  const Ray ray{y.ray_origin(), wi};
  const std::optional<Hit> hit = hit_of_bounce(ray, visibility);
  if (!hit) return;
  Vertex z = scene.vertex(ray, *hit);
  if (counted && z.light != kNone) {
    const AreaLight& light = scene.lights()[z.light];
    const float light_pdf =
        scene.light_pmf(z.light) * options.method->pdf_w(light, y.position, z.position);
    terms.push_back({wi, light.Le, light_pdf, 1});
  }
  log.steps.assign(1, {});
  terms.push_back({wi, walk(scene, options, z, 2, Rgb(0.0f), path.sampler, visibility, log), 0, 1});
}

}  // namespace

PathGroup::PathGroup(const Scene& scene, const ShadeOptions& options)
    : scene_(scene), options_(options), scratch_(std::make_unique<Scratch>()) {}
PathGroup::~PathGroup() = default;
PathGroup::PathGroup(PathGroup&&) noexcept = default;

void PathGroup::shade(std::span<SharedPath> paths, Visibility& visibility, PathLog& log,
                      std::size_t logged) {
  Scratch& s = *scratch_;
  s.views.begin(paths.size());
  first_hits(paths, visibility, s.hits);
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const auto x =
        start(scene_, options_, s.hits[k], paths[k], visibility, k == logged ? log : s.walk_log);
    if (x) s.views.set_first(k, *x);
  }
  for (std::size_t j = 0; j < paths.size(); ++j) {
    if (!paths[j].second) continue;
    const Vertex& y = *paths[j].second;
    const Rgb before = s.views.gathered(logged);
    if (wants_mis(*y.material)) {
      glossy_terms(scene_, options_, paths[j], visibility, s.directions, s.walk_log, s.terms);
      std::erase_if(s.terms, [](const Term& term) { return is_black(term.light); });
    } else {
      s.walk_log.steps.assign(1, {});
      Vertex v = y;
      s.terms.assign(
          1, {Vec3(0.0f),
              walk(scene_, options_, v, 1, Rgb(0.0f), paths[j].sampler, visibility, s.walk_log), 1,
              0});
      if (is_black(s.terms[0].light)) continue;
    }
    if (s.terms.empty()) continue;
    s.views.look_at(y, j, visibility);
    for (const Term& term : s.terms)
      wants_mis(*y.material) ? s.views.add_glossy(term, y) : s.views.add_diffuse(term.light);
    const Rgb light = s.views.gathered(logged) - before;
    if (!is_black(light))
      log.steps.push_back({y.position, y.ng, Rgb(0.0f), Rgb(0.0f), light, kNone, 0});
  }
  for (std::size_t k = 0; k < paths.size(); ++k) paths[k].radiance += s.views.gathered(k);
}

}  // namespace raytracing
