#pragma once
// The steps of a path that all path tracers have in common: first vertex, direct light, bounce.

#include <array>

#include "raytracing/integrator/path_tracer.h"

namespace raytracing {

/// What all paths of one thread share.
struct PathContext {
  const Scene& scene;
  const PathOptions& options;
  RayQueries& rays;
};

/// One path: where it has come to, and what it carries.
struct PathState {
  PathState(PathSampler& path_sampler, PathLog& path_log) : sampler(path_sampler), log(path_log) {}

  PathSampler& sampler;
  PathLog& log;
  std::uint32_t depth = 0;  ///< number of the current vertex; the first one is 0
  Rgb throughput{1.0f};     ///< of the bounces so far
  Rgb radiance{0.0f};       ///< found so far, as it leaves the vertex at which the path began

  const Vertex& vertex() const { return vertices_[current_]; }
  /// The vertex that the last bounce left.
  const Vertex& previous() const { return vertices_[current_ ^ 1]; }

  /// Begins a path that has found nothing at the vertex of number `at_depth`. The log gets an empty
  /// step for it.
  void begin(const Vertex& v, std::uint32_t at_depth) {
    depth = at_depth;
    throughput = Rgb(1.0f);
    radiance = Rgb(0.0f);
    vertices_[current_] = v;
    log.steps.assign(1, {});
  }
  /// Moves on to the hit of a ray that left the current vertex, or the camera.
  void move_to(const Scene& scene, const Ray& ray, const Hit& hit) {
    current_ ^= 1;
    vertices_[current_] = scene.vertex(ray, hit);
  }

 private:
  std::array<Vertex, 2> vertices_;
  unsigned current_ = 0;
};

/// How a path goes on.
struct Scattered {
  Vec3 wi;  ///< world
  Rgb weight;
  float pdf_w;
};

/// The first vertex of the sample's path, at the hit of the camera ray; adds its emission.
void begin_at_camera(const PathContext& in, PathState& path, const PathSample& sample,
                     const Hit& hit);

/// The estimate of direct light at the vertex `v` of number `depth`. `samples`, where given, is
/// cleared and receives the directions that the estimate sums.
Rgb direct_light(const PathContext& in, const Vertex& v, std::uint32_t depth, PathSampler& sampler,
                 std::vector<LightSample>* samples = nullptr);

/// Adds the direct light at the current vertex.
void add_direct_light(const PathContext& in, PathState& path);

/// The direction in which the BSDF lets the path go on. Nothing where the path is absorbed, or
/// where it would go below the true surface, of which the shading normal knows nothing.
std::optional<Scattered> scatter(const PathState& path);

/// Follows `wi` to the next vertex. False, and counted as escaped, where the ray meets nothing.
bool advance(const PathContext& in, PathState& path, const Vec3& wi);

/// One bounce: scattering, roulette, the next vertex, and the emission that it counts. False where
/// the path ends.
bool bounce(const PathContext& in, PathState& path);

/// The density per steradian, choice of the light included, with which light sampling at the
/// previous vertex would have found the current one, which lies on a light.
float light_pdf_w(const PathContext& in, const PathState& path);

/// One vertex of the path and what follows it directly: the direct light there and the bounce.
/// False where the path ends.
bool trace_vertex(const PathContext& in, PathState& path);

/// Follows the path from its current vertex to its end.
void trace_path(const PathContext& in, PathState& path);

}  // namespace raytracing
