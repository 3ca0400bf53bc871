#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"
#include "progress_display.h"
#include "raytracing/io/scene_file.h"
#include "raytracing/render/render.h"

namespace raytracing {

/// What the command line of `render` asks for. Empty optionals leave the choice to the scene file.
struct RenderArguments {
  struct Replay {
    int x, y;
    std::uint64_t sample;
  };

  std::string scene;
  std::optional<std::uint64_t> spp;
  std::uint64_t replicates = 1;
  int reuse = 16;
  std::string light_sampling;  // "" = the scene's
  int line_rays = 4;
  std::vector<std::string> outputs;
  std::optional<int> width, height;
  std::optional<std::uint32_t> max_depth;
  std::uint64_t seed = 0;
  SamplerKind sampler = SamplerKind::sobol;
  int threads = 1;
  bool variance = false;
  std::string stats;  // "" = none
  ProgressStyle progress = ProgressStyle::automatic;
  bool quiet = false;
  bool strict = false;
  std::optional<Replay> replay;
  /// Text that the command line asked for instead of a picture: help, version, list of methods.
  std::optional<std::string> text;
};

/// Parses and checks the command line. Throws UsageError.
RenderArguments parse_render_arguments(const Arguments& arguments);

/// The settings of the rendering: the command line's, else the scene file's. Throws UsageError
/// where they do not fit together.
RenderOptions render_options(const RenderArguments& arguments, const SceneFile& scene);

}  // namespace raytracing
