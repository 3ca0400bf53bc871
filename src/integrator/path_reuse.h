#pragma once

#include <array>
#include <vector>

#include "group_connections.h"
#include "path.h"

namespace raytracing {

/// The PathTracer whose samples use each other's paths: each sample has a first vertex of its own,
/// and all of a group receive light from the vertex at which the bounce of any arrives.
class SharedPathTracer final : public PathTracer {
 public:
  SharedPathTracer(const Scene& scene, const PathOptions& options)
      : scene_(scene), options_(options) {}

  void trace(std::span<PathSample> samples, RayQueries& rays, PathLog& log,
             std::size_t logged) override;

 private:
  void find_first_hits(const PathContext& in, std::span<const PathSample> samples);
  void start(const PathContext& in, PathSample& sample, std::size_t k, PathLog& log);
  void find_light(const PathContext& in, const Vertex& y, PathSampler& sampler);
  void find_light_samples(const PathContext& in, const Vertex& y, PathSampler& sampler);
  void follow_bounce(const PathContext& in, const Vertex& y, PathSampler& sampler);

  const Scene& scene_;
  const PathOptions options_;
  // Scratch of trace(), by sample.
  std::array<std::optional<Hit>, kMaxSamples> first_hits_;
  std::array<std::optional<Vertex>, kMaxSamples> second_;  // where the first bounce arrived
  GroupConnections connections_;
  std::vector<Term> terms_;
  std::vector<LightSample> light_samples_;
  PathLog unwanted_log_;
};

}  // namespace raytracing
