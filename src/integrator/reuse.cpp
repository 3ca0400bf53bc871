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

#include "path_steps.h"
#include "raytracing/materials/bsdf.h"
#include "reuse_lanes.h"

namespace raytracing {
namespace {

// The first vertices of the group, a lane each. A lane without a vertex reflects nothing.
struct FirstVertices {
  Vec3Lanes origin, ng, ns, wo;  // world; origin of rays
  Vec3Lanes reflectance;
  Lanes ggx, alpha2, schlick;

  void clear(int k) {
    for (Vec3Lanes* lanes : {&origin, &ng, &ns, &wo, &reflectance}) lanes->set(k, Vec3(0.0f));
    ggx[k] = schlick[k] = 0;
    alpha2[k] = 1;
  }
  void set(int k, const Vertex& v) {
    const LobeShape shape(*v.material);
    origin.set(k, v.ray_origin());
    ng.set(k, v.ng);
    ns.set(k, v.shading.z);
    wo.set(k, v.shading.to_world(v.wo));
    reflectance.set(k, shape.reflectance);
    ggx[k] = shape.ggx;
    alpha2[k] = shape.alpha2;
    schlick[k] = shape.schlick;
  }
};

// How the first vertices see one second vertex y.
struct alignas(64) Views {
  Vec3Lanes wo;  // from y to x_k, unit
  Lanes pdf_a;   // p_k(y); 0 = does not see it
  Lanes value;   // f_x G but for the reflectance
  Lanes white;   // see Lobe
};

// Light that leaves y for all its viewers: f_y(w) light / sum over k of p_k (light_pdf + bsdf p_b).
struct Term {
  Vec3 wi;
  Rgb light;
  float light_pdf;
  float bsdf;  // 1 = the BSDF may choose w, 0 = it may not
};

}  // namespace

struct PathGroup::Scratch {
  FirstVertices first;
  Views views;
  Vec3Lanes gathered;  // radiance by way of second vertices
  std::vector<Term> terms;
  std::vector<LightSample> directions;
  PathLog walk_log;
  int lanes = 0;  // a multiple of 8

  void see(const Vertex& y, int owner);
  void hide(const Vertex& y, int owner, Visibility& visibility);
  void add_diffuse(const Rgb& light);
  void add_glossy(const Term& term, const Vertex& y);
};

// Views of y, as if nothing stood between.
void PathGroup::Scratch::see(const Vertex& y, int owner) {
  const Vec3 position = y.position, ng = y.ng, ns = y.shading.z;
  for (int k = 0; k < lanes; ++k) {
    const Vec3 d = position - first.origin.at(k);
    const float distance2 = dot(d, d);
    const Vec3 wi = d / std::sqrt(distance2);
    const float cos_y = -dot(wi, ng);
    const Vec3 nx = first.ns.at(k);
    const float above = std::min(std::min(cos_y, -dot(wi, ns)),
                                 std::min(dot(wi, nx), dot(wi, first.ng.at(k))));
    const Lobe l =
        lobe(first.ggx[k], first.alpha2[k], first.schlick[k], nx, first.wo.at(k), wi);
    const float geometry = above > 0 ? cos_y / distance2 : 0.0f;
    views.wo.x[k] = -wi.x;
    views.wo.y[k] = -wi.y;
    views.wo.z[k] = -wi.z;
    views.pdf_a[k] = geometry > 0 ? l.pdf_w * geometry : 0.0f;
    views.value[k] = geometry > 0 ? l.value * geometry : 0.0f;
    views.white[k] = geometry > 0 ? l.white : 0.0f;
  }
  if (!y.normal_replaced) return;
  for (int k = 0; k < lanes; ++k)
    if (k != owner) views.pdf_a[k] = views.value[k] = 0;
}

// Takes out the views that something stands in. The owner's bounce has arrived at y.
void PathGroup::Scratch::hide(const Vertex& y, int owner, Visibility& visibility) {
  const Vec3 from = y.ray_origin();
  for (int begin = 0; begin < lanes; begin += 8) {
    unsigned wanted = 0;
    for (int i = 0; i < 8; ++i)
      if (views.pdf_a[begin + i] > 0 && begin + i != owner) wanted |= 1u << i;
    if (wanted == 0) continue;
    const unsigned hidden = visibility.occluded8(from, &first.origin.x[begin],
                                                 &first.origin.y[begin], &first.origin.z[begin],
                                                 wanted);
    for (int i = 0; i < 8; ++i)
      if ((hidden >> i) & 1) views.pdf_a[begin + i] = views.value[begin + i] = 0;
  }
}

void PathGroup::Scratch::add_diffuse(const Rgb& light) {
  const float density = sum(views.pdf_a, lanes);
  if (!(density > 0)) return;
  const Rgb shared = light / density;
  // Light that has overflowed is nobody's who does not see it.
  const auto add = [&](Lanes& to, const Lanes& reflectance, float amount) {
    for (int k = 0; k < lanes; ++k) {
      const float here = reflectance[k] + (1 - reflectance[k]) * views.white[k];
      to[k] += views.value[k] > 0 ? views.value[k] * here * amount : 0.0f;
    }
  };
  add(gathered.x, first.reflectance.x, shared.x);
  add(gathered.y, first.reflectance.y, shared.y);
  add(gathered.z, first.reflectance.z, shared.z);
}

void PathGroup::Scratch::add_glossy(const Term& term, const Vertex& y) {
  const LobeShape shape(*y.material);
  const Vec3 ns = y.shading.z;
  alignas(64) Lanes densities, value, white;
  for (int k = 0; k < lanes; ++k) {
    const Lobe l = lobe(shape.ggx, shape.alpha2, shape.schlick, ns, views.wo.at(k), term.wi);
    const bool seen = views.pdf_a[k] > 0;
    densities[k] = seen ? views.pdf_a[k] * (term.light_pdf + term.bsdf * l.pdf_w) : 0.0f;
    value[k] = seen ? views.value[k] * l.value : 0.0f;
    white[k] = seen ? l.white : 0.0f;
  }
  const float density = sum(densities, lanes);
  if (!(density > 0)) return;
  const Rgb shared = term.light / density;
  const auto add = [&](Lanes& to, const Lanes& reflectance, float at_y, float amount) {
    for (int k = 0; k < lanes; ++k) {
      const float here = reflectance[k] + (1 - reflectance[k]) * views.white[k];
      const float there = at_y + (1 - at_y) * white[k];
      to[k] += value[k] > 0 ? value[k] * here * there * amount : 0.0f;
    }
  };
  add(gathered.x, first.reflectance.x, shape.reflectance.x, shared.x);
  add(gathered.y, first.reflectance.y, shape.reflectance.y, shared.y);
  add(gathered.z, first.reflectance.z, shape.reflectance.z, shared.z);
}

namespace {

// One vertex and its bounce, as shade() has them; what they carry to the viewer without sharing.
// Returns the first vertex, or nothing where the camera ray meets none.
std::optional<Vertex> start(const Scene& scene, const ShadeOptions& options, SharedPath& path,
                            Visibility& visibility, PathLog& log) {
  log.steps.clear();
  path.radiance = Rgb(0.0f);
  path.second.reset();
  const std::optional<Hit> hit = visibility.closest_hit(path.ray);
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
    log.steps.push_back({path.second->position, path.second->ng, scattered->weight, met,
                         Rgb(0.0f), path.second->light, 0});
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
  s.lanes = static_cast<int>(paths.size() + 7) / 8 * 8;
  for (int k = 0; k < s.lanes; ++k) {
    s.first.clear(k);
    s.gathered.set(k, Vec3(0.0f));
  }
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const auto x =
        start(scene_, options_, paths[k], visibility, k == logged ? log : s.walk_log);
    if (x) s.first.set(static_cast<int>(k), *x);
  }
  for (std::size_t j = 0; j < paths.size(); ++j) {
    if (!paths[j].second) continue;
    const Vertex& y = *paths[j].second;
    const Rgb before = s.gathered.at(static_cast<int>(logged));
    if (wants_mis(*y.material)) {
      glossy_terms(scene_, options_, paths[j], visibility, s.directions, s.walk_log, s.terms);
      std::erase_if(s.terms, [](const Term& term) { return is_black(term.light); });
    } else {
      s.walk_log.steps.assign(1, {});
      Vertex v = y;
      s.terms.assign(1, {Vec3(0.0f),
                         walk(scene_, options_, v, 1, Rgb(0.0f), paths[j].sampler, visibility,
                              s.walk_log),
                         1, 0});
      if (is_black(s.terms[0].light)) continue;
    }
    if (s.terms.empty()) continue;
    s.see(y, static_cast<int>(j));
    s.hide(y, static_cast<int>(j), visibility);
    for (const Term& term : s.terms)
      wants_mis(*y.material) ? s.add_glossy(term, y) : s.add_diffuse(term.light);
    const Rgb light = s.gathered.at(static_cast<int>(logged)) - before;
    if (!is_black(light))
      log.steps.push_back({y.position, y.ng, Rgb(0.0f), Rgb(0.0f), light, kNone, 0});
  }
  for (std::size_t k = 0; k < paths.size(); ++k)
    paths[k].radiance += s.gathered.at(static_cast<int>(k));
}

}  // namespace raytracing
