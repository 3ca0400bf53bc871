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

#include "path.h"

#include <algorithm>

namespace raytracing {
namespace {

constexpr std::uint32_t kUnlimited = ~0u;
constexpr std::uint32_t kRouletteDepth = 4;

// Pairs of the sampler: 0 is the position in the pixel, then there are three for each vertex.
constexpr std::uint32_t kPairsPerVertex = 3;
constexpr std::uint32_t light_pair(std::uint32_t depth) { return 1 + kPairsPerVertex * depth; }
constexpr std::uint32_t bsdf_pair(std::uint32_t depth) { return light_pair(depth) + 1; }
constexpr std::uint32_t choice_pair(std::uint32_t depth) { return light_pair(depth) + 2; }

// The survival is below 1, so that a path in a room without losses ends: of n more bounces all are
// made with a probability of about (1 + n / 200)^-4. A fixed bound c would do that too, but its
// weights grow like c^-n, and their variance is infinite where a bounce keeps more than sqrt(c) of
// the light. These grow more slowly than any loss takes away.
float max_survival(std::uint32_t depth) { return 1 - 4 / (200 + static_cast<float>(depth)); }

// The emission of the vertex that a bounce with this density arrived at, as weighted against light
// sampling.
Rgb weighted_emission(const PathContext& in, const PathState& path, float bsdf_pdf_w) {
  const Vertex& v = path.vertex();
  if (v.light == kNone || !in.options.method->uses_mis(*path.previous().material)) return Rgb(0.0f);
  return in.scene.lights()[v.light].Le * balance_heuristic(bsdf_pdf_w, light_pdf_w(in, path));
}

}  // namespace

void begin_at_camera(const PathContext& in, PathState& path, const PathSample& sample,
                     const Hit& hit) {
  path.move_to(in.scene, sample.ray, hit);
  const Vertex& v = path.vertex();
  if (v.light != kNone) path.radiance = in.scene.lights()[v.light].Le;
  path.log.steps.push_back({v.position, v.ng, Rgb(1.0f), path.radiance, Rgb(0.0f), v.light, 0});
  if (sample.first_hit != nullptr) *sample.first_hit = describe_first_hit(in.scene, v, sample.ray);
}

Rgb direct_light(const PathContext& in, const Vertex& v, std::uint32_t depth, PathSampler& sampler,
                 std::vector<LightSample>* samples) {
  if (samples != nullptr) samples->clear();
  if (in.scene.lights().empty()) return Rgb(0.0f);
  const auto chosen = in.scene.choose_light(sampler.pair(choice_pair(depth)).x);
  const std::uint32_t pair = light_pair(depth);
  const DirectQuery query{v,
                          in.scene.lights()[chosen.index],
                          chosen.pmf,
                          sampler.pair(pair),
                          sampler,
                          pair,
                          in.options.line_rays};
  return estimate_direct(*in.options.method, query, in.rays, samples);
}

void add_direct_light(const PathContext& in, PathState& path) {
  const Rgb direct = path.throughput * direct_light(in, path.vertex(), path.depth, path.sampler);
  path.radiance += direct;
  path.log.steps.back().direct = direct;
}

std::optional<Scattered> scatter(const PathState& path) {
  const Vertex& v = path.vertex();
  const auto sample = sample_bsdf(*v.material, v.wo, path.sampler.pair(bsdf_pair(path.depth)));
  if (!sample) return std::nullopt;
  const Vec3 wi = v.shading.to_world(sample->wi);
  if (dot(wi, v.ng) <= 0) return std::nullopt;
  return Scattered{wi, sample->weight, sample->pdf_w};
}

bool advance(const PathContext& in, PathState& path, const Vec3& wi) {
  const Ray ray{path.vertex().ray_origin(), wi};
  const std::optional<Hit> hit = in.rays.closest_hit(ray);
  if (!hit) {
    in.rays.count_escaped();
    return false;
  }
  path.move_to(in.scene, ray, *hit);
  ++path.depth;
  return true;
}

bool bounce(const PathContext& in, PathState& path) {
  const std::optional<Scattered> scattered = scatter(path);
  if (!scattered) return false;
  path.throughput *= scattered->weight;
  float survival = 1;
  if (path.depth + 1 >= kRouletteDepth) {
    survival = std::min(max_survival(path.depth), max_component(path.throughput));
    if (!(path.sampler.pair(choice_pair(path.depth)).y < survival)) return false;
    path.throughput *= 1 / survival;
  }
  if (!advance(in, path, scattered->wi)) return false;
  path.log.steps.back().survival = survival;
  const Vertex& v = path.vertex();
  const Rgb emitted = path.throughput * weighted_emission(in, path, scattered->pdf_w);
  path.radiance += emitted;
  path.log.steps.push_back({v.position, v.ng, path.throughput, emitted, Rgb(0.0f), v.light, 0});
  return true;
}

float light_pdf_w(const PathContext& in, const PathState& path) {
  const Vertex& v = path.vertex();
  return in.scene.light_pmf(v.light) *
         in.options.method->pdf_w(in.scene.lights()[v.light], path.previous(), v.position);
}

bool trace_vertex(const PathContext& in, PathState& path) {
  const std::uint32_t max_depth = in.options.max_depth.value_or(kUnlimited);
  if (path.depth >= max_depth) return false;
  add_direct_light(in, path);
  // The last bounce is made for the emission that it may find.
  const bool is_last = path.depth + 1 == max_depth;
  if (is_last && !in.options.method->uses_mis(*path.vertex().material)) return false;
  return bounce(in, path);
}

void trace_path(const PathContext& in, PathState& path) {
  while (trace_vertex(in, path)) {
  }
}

}  // namespace raytracing
