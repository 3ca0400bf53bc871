#pragma once
// The options that several subcommands share, with their help texts.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "options.h"
#include "raytracing/integrator/direct_method.h"
#include "terminal.h"

namespace raytracing {

/// What every subcommand that traces paths accepts.
struct RunArguments {
  RunArguments();

  int line_rays = 4;
  int threads;  ///< by default, as many as the hardware runs at once
  ProgressStyle progress = ProgressStyle::automatic;
  bool quiet = false;

  ProgressStyle shown_progress() const { return quiet ? ProgressStyle::none : progress; }
};

/// What every subcommand that renders a scene file accepts. An empty optional leaves the choice to
/// the scene file.
struct SceneArguments : RunArguments {
  std::string scene;  ///< as given on the command line, or the file that was found for it
  std::optional<int> width, height;
  std::optional<std::uint32_t> max_depth;
  SamplerKind sampler = SamplerKind::sobol;
};

/// Adds --scene, also as the only positional argument.
void add_scene_option(OptionList& options, std::string& scene);

/// Replaces the scene's name by the path of its file. Throws UsageError if there is no name and
/// InputError, which lists what was looked for and ends with `hint`, if there is no such file.
void resolve_scene(std::string& scene, const std::string& hint = "");

/// Adds --width and --height.
void add_size_options(OptionList& options, SceneArguments& a);

/// Adds --max-depth and --sampler.
void add_path_options(OptionList& options, SceneArguments& a);

/// Adds --line-rays.
void add_line_rays_option(OptionList& options, RunArguments& a);

/// Adds --methods: a list of direct-light methods; all of them by default.
void add_methods_option(OptionList& options, std::vector<const DirectMethod*>& methods);

/// Adds --mask.
void add_mask_option(OptionList& options, std::string& mask);

/// Adds --threads, --progress and --quiet.
void add_run_options(OptionList& options, RunArguments& a);

/// Throws UsageError if an output is the same file as an input or another output, even by another
/// path. Empty names stand for no file.
void check_distinct(const std::vector<std::string>& inputs,
                    const std::vector<std::string>& outputs);

}  // namespace raytracing
