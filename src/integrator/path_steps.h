#pragma once
// The steps of a path that shade() and the reuse of paths have in common.

#include "raytracing/integrator/shade.h"
#include "raytracing/materials/bsdf.h"

namespace raytracing {

// Pairs of the sampler: 0 is the position in the pixel, then three for each vertex.
constexpr std::uint32_t kPairsPerVertex = 3;
constexpr std::uint32_t light_pair(std::uint32_t vertex) { return 1 + kPairsPerVertex * vertex; }
constexpr std::uint32_t bsdf_pair(std::uint32_t vertex) { return light_pair(vertex) + 1; }
constexpr std::uint32_t choice_pair(std::uint32_t vertex) { return light_pair(vertex) + 2; }

struct Bounce {
  Vec3 from;
  float pdf_w;   // of BSDF sampling
  bool counted;  // whether light that it meets shall count
};

/// How a path goes on.
struct Scattered {
  Vec3 wi;  // world
  Rgb weight;
  float pdf_w;
};

/// The direction in which the BSDF lets the path go on at `v`, the vertex of number `depth`.
/// Nothing where the path is absorbed, or where it would go below the true surface, of which the
/// shading normal knows nothing.
inline std::optional<Scattered> scatter(const Vertex& v, std::uint32_t depth,
                                        PathSampler& sampler) {
  const auto sample = sample_bsdf(*v.material, v.wo, sampler.pair(bsdf_pair(depth)));
  if (!sample) return std::nullopt;
  const Vec3 wi = v.shading.to_world(sample->wi);
  if (dot(wi, v.ng) <= 0) return std::nullopt;
  return Scattered{wi, sample->weight, sample->pdf_w};
}

/// What the bounce meets. Without anything, it is counted as escaped.
inline std::optional<Hit> hit_of_bounce(const Ray& ray, Visibility& visibility) {
  const std::optional<Hit> hit = visibility.closest_hit(ray);
  if (!hit) visibility.count_escaped();
  return hit;
}

/// What a vertex that lies on a light emits to the viewer, as far as it is counted here. Without a
/// bounce the viewer is the camera.
Rgb emission(const Scene& scene, const DirectMethod& method, const Vertex& v, const Bounce* bounce);

/// The estimate of direct light at the vertex of number `depth`. `directions`, where given, are
/// cleared, and receive those of a vertex that is not diffuse.
Rgb direct_light(const Scene& scene, const ShadeOptions& options, const Vertex& v,
                 std::uint32_t depth, PathSampler& sampler, Visibility& visibility,
                 std::vector<LightSample>* directions = nullptr);

/// The walk over the vertices from `v`, of number `depth`, on: `radiance` and what `v` reflects to
/// the viewer. The log must hold the step of `v`, and receives those of the vertices after it. `v`
/// moves along and ends at the last of them.
Rgb walk(const Scene& scene, const ShadeOptions& options, Vertex& v, std::uint32_t depth,
         Rgb radiance, PathSampler& sampler, Visibility& visibility, PathLog& log);

}  // namespace raytracing
