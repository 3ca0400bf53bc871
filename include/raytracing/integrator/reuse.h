#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "raytracing/integrator/shade.h"

namespace raytracing {

/// One sample of a pixel that shares paths with others.
struct SharedPath {
  Ray ray;  ///< of the camera
  PathSampler sampler;
  Rgb radiance{0.0f};                           ///< the result
  std::optional<Vertex> second = std::nullopt;  ///< where its first bounce arrived
};

/// Estimates the radiance of a few samples at once, which use each other's paths (Bekaert, Sbert &
/// Halton 2002): each has the expectation of shade(), far less variance, and errors like those of
/// its group. One per thread; its memory is used again.
class PathGroup {
 public:
  static constexpr std::size_t kMaxPaths = 256;

  PathGroup(const Scene& scene, const ShadeOptions& options);
  ~PathGroup();
  PathGroup(PathGroup&&) noexcept;

  /// For max_depth >= 2: below, there is nothing to share. `paths` are 1 to kMaxPaths; their
  /// samplers stand where shade() wants them. `log` receives what makes the radiance of
  /// paths[logged]: its first vertex, the light that its own bounce met, and each second vertex of
  /// the group that shines on it; there, `throughput` is left black and `direct` is all the light
  /// that comes by way of that vertex.
  void shade(std::span<SharedPath> paths, Visibility& visibility, PathLog& log, std::size_t logged);

 private:
  struct Scratch;
  const Scene& scene_;
  const ShadeOptions& options_;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace raytracing
