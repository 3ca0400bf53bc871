// The integrand. A path of k reflections carries to the viewer
//
//   L_k = f_1 cos_1 / p_1 * ... * f_k-1 cos_k-1 / p_k-1   throughput of the bounces before
//         / (q_4 ... )                                    survival of roulette, from depth 4 on
//         * D(x_k)                                        direct light at its last vertex
//
// where p is the density of BSDF sampling and D the estimate of the chosen method from one light,
// over the light's probability. A camera ray that meets a light adds its emission. A bounce that
// meets a light adds it only with the weight that the method left to BSDF sampling (balance
// heuristic): none where the method has no density, or where the material asks for none.

#include "raytracing/integrator/shade.h"

#include "path_steps.h"
#include "raytracing/sampling/mis.h"

namespace raytracing {
namespace {

constexpr std::uint32_t kUnlimited = ~0u;
constexpr std::uint32_t kRouletteDepth = 4;

// Below 1, so that a path in a room without losses ends: of n more bounces all are made with a
// probability of about (1 + n / 200)^-4. A fixed bound c would do that too, but its weights grow
// like c^-n, and their variance is infinite where a bounce keeps more than sqrt(c) of the light.
// These grow more slowly than any loss takes away.
float largest_survival(std::uint32_t depth) { return 1 - 4 / (200 + static_cast<float>(depth)); }

}  // namespace

Rgb emission(const Scene& scene, const DirectMethod& method, const Vertex& v,
             const Bounce* bounce) {
  if (v.light == kNone) return Rgb(0.0f);
  const AreaLight& light = scene.lights()[v.light];
  if (bounce == nullptr) return light.Le;
  if (!bounce->counted) return Rgb(0.0f);
  const float light_pdf = scene.light_pmf(v.light) * method.pdf_w(light, bounce->from, v.position);
  return light.Le * balance_heuristic(bounce->pdf_w, light_pdf);
}

Rgb direct_light(const Scene& scene, const ShadeOptions& options, const Vertex& v,
                 std::uint32_t depth, PathSampler& sampler, Visibility& visibility,
                 std::vector<LightSample>* directions) {
  if (directions != nullptr) directions->clear();
  if (scene.lights().empty()) return Rgb(0.0f);
  const auto chosen = scene.choose_light(sampler.pair(choice_pair(depth)).x);
  const AreaLight& light = scene.lights()[chosen.index];
  const std::uint32_t pair = light_pair(depth);
  const DirectQuery query{v,       light, chosen.pmf,        sampler.pair(pair),
                          sampler, pair,  options.line_rays, directions};
  const Rgb reflected = options.method->estimate(query, visibility) * (1 / chosen.pmf);
  if (directions != nullptr)
    for (LightSample& sample : *directions) sample.light /= chosen.pmf;
  return reflected;
}

Rgb walk(const Scene& scene, const ShadeOptions& options, Vertex& v, std::uint32_t depth,
         Rgb radiance, PathSampler& sampler, Visibility& visibility, PathLog& log) {
  Rgb throughput(1.0f);
  const std::uint32_t max_depth = options.max_depth.value_or(kUnlimited);
  for (; depth < max_depth; ++depth) {
    const Rgb direct = throughput * direct_light(scene, options, v, depth, sampler, visibility);
    radiance += direct;
    log.steps.back().direct = direct;

    const bool counted = options.method->uses_mis(*v.material);
    if (depth + 1 == max_depth && !counted) break;
    const auto scattered = scatter(v, depth, sampler);
    if (!scattered) break;
    throughput *= scattered->weight;

    float survival = 1;
    if (depth + 1 >= kRouletteDepth) {
      survival = std::min(largest_survival(depth), max_component(throughput));
      if (!(sampler.pair(choice_pair(depth)).y < survival)) break;
      throughput *= 1 / survival;
    }
    const Bounce bounce{v.position, scattered->pdf_w, counted};
    const Ray ray{v.ray_origin(), scattered->wi};
    const std::optional<Hit> hit = hit_of_bounce(ray, visibility);
    if (!hit) break;
    log.steps.back().survival = survival;
    v = scene.vertex(ray, *hit);
    const Rgb emitted = throughput * emission(scene, *options.method, v, &bounce);
    radiance += emitted;
    log.steps.push_back({v.position, v.ng, throughput, emitted, Rgb(0), v.light, 0});
  }
  return radiance;
}

Rgb shade(const Scene& scene, const ShadeOptions& options, const Ray& ray, PathSampler& sampler,
          Visibility& visibility, PathLog& log) {
  log.steps.clear();
  const std::optional<Hit> hit = visibility.closest_hit(ray);
  if (!hit) return Rgb(0.0f);
  Vertex v = scene.vertex(ray, *hit);
  const Rgb emitted = emission(scene, *options.method, v, nullptr);
  log.steps.push_back({v.position, v.ng, Rgb(1.0f), emitted, Rgb(0), v.light, 0});
  return walk(scene, options, v, 0, emitted, sampler, visibility, log);
}

}  // namespace raytracing
