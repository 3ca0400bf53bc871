#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app.h"
#include "common_options.h"
#include "raytracing/io/scene_file.h"
#include "raytracing/render/render.h"

namespace raytracing {

/// The command line of `render`.
struct RenderArguments : SceneArguments {
  struct Replay {
    int x, y;
    std::uint64_t sample;
  };

  std::optional<std::uint64_t> spp;
  std::uint64_t replicates = 1;
  int reuse = 16;
  std::optional<std::string> light_sampling;  ///< the name of a direct-light method
  std::vector<std::string> outputs;
  bool as_float = false;  ///< whether --float was given
  std::uint64_t seed = 0;
  std::vector<const Layer*> layers;  ///< that EXR images get, each once
  bool variance = false;             ///< whether --variance asked for that layer
  std::string stats;                 ///< "" = none
  bool strict = false;
  std::optional<Replay> replay;
};

/// Parses and checks the command line. Throws UsageError; InputError if there is no such scene.
RenderArguments parse_render_arguments(const Arguments& arguments);

/// Completes the settings of the command line from the scene file. Throws UsageError if they do
/// not fit together.
RenderOptions render_options(const RenderArguments& arguments, const SceneFile& scene);

}  // namespace raytracing
