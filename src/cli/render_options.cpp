#include "render_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>

#include "build_info.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/image.h"
#include "raytracing/render/pixel_groups.h"
#include "raytracing/sampling/sampler.h"
#include "raytracing/scene/description.h"
#include "scene_input.h"

namespace raytracing {
namespace {

constexpr std::uint64_t kMaxReplicates = 65536;

std::string methods_text() {
  std::string text;
  for (const DirectMethod& m : direct_methods())
    text += fmt::format("{:<12} {}: {}; costs {}\n", m.name, m.unbiased ? "unbiased" : "BIASED",
                        m.summary, m.cost);
  return text;
}

// The lines break where the options' descriptions do.
std::string layers_text() {
  constexpr std::size_t kWidth = 85, kIndent = 13;
  std::string text;
  for (const Layer& layer : layers()) {
    const std::string channels = fmt::format("{}", fmt::join(layer.channels(), ", "));
    text += fmt::format("{:<12} {}\n", layer.name,
                        wrapped(fmt::format("{}: {}", channels, layer.meaning), kWidth, kIndent));
  }
  return text;
}

std::string subcommands_text() {
  std::string text = "Subcommands (render is the default; each has its own --help):\n";
  for (const Command& command : commands())
    text += fmt::format("{:<12} {}\n", command.name, command.summary);
  return text + "\n";
}

// Returns true for a name that is perhaps a misspelt subcommand.
bool is_word(const std::string& scene) { return scene.find_first_of("./") == std::string::npos; }

std::string subcommand_hint(const std::string& name) {
  std::vector<std::string> names;
  for (const Command& command : commands()) names.emplace_back(command.name);
  return "; the nearest subcommand is " + nearest_name(name, names);
}

RenderArguments::Replay parse_replay(const std::string& text) {
  const std::vector<std::string> parts = split_list(text);
  if (parts.size() != 3)
    throw CLI::ValidationError("--replay", "'" + text + "' is not of the form X,Y,SAMPLE");
  const auto number = [&](std::size_t i, std::uint64_t high) {
    return std::stoull(checked("--replay", parts[i], whole_number(0, high)));
  };
  return {static_cast<int>(number(0, kMaxImageSize - 1)),
          static_cast<int>(number(1, kMaxImageSize - 1)), number(2, kMaxSpp - 1)};
}

std::string check_power_of_two(const std::string& edge) {
  return std::has_single_bit(std::stoull(edge)) ? "" : "must be 1, 2, 4, 8 or 16, not " + edge;
}

void add_variance(std::vector<const Layer*>& layers) {
  const Layer* variance = find_layer("variance");
  if (std::find(layers.begin(), layers.end(), variance) == layers.end()) layers.push_back(variance);
}

void add_output_options(OptionList& options, RenderArguments& a) {
  options.values(
      "-o,--output", a.outputs, "FILE",
      "Image to write: .exr (linear, 32-bit float), .hdr (linear, shared exponent), .png, "
      ".jpg or .tif (sRGB, 8 bits per channel), or another format that OpenImageIO writes "
      "with 8 bits. May be repeated. Default: the name of the scene with .png, in the "
      "working directory.");
  options.flag("--float", a.as_float, "Write .tif images as linear 32-bit floats.");
  options.list(
      "--layers", a.layers, "A,B,...",
      [](const std::string& name) {
        return find_layer(checked("--layers", name, one_of(layer_names())));
      },
      "Layers to add to EXR images, beside R, G and B: any of " + alternatives(layer_names()) +
          " (described below).");
  options.flag("--variance", a.variance, "The same as --layers variance.");
  options.value("--stats", a.stats, "FILE", "Write statistics of the rendering as JSON.");
}

void add_sampling_options(OptionList& options, RenderArguments& a) {
  options.number("--spp", a.spp, 1, kMaxSpp,
                 "Samples per pixel. Default: taken from the scene file.");
  options.number(
      "--replicates", a.replicates, 1, kMaxReplicates,
      "Split the samples of each pixel into N replicates, groups of equal size with "
      "independent scramblings; N must divide the samples per pixel. With 2 or more, "
      "--variance is estimated from the replicate means, which is right for sobol too; 8 "
      "or 16 are good choices. Confidence intervals take Student's t with N-1 degrees "
      "of freedom (95 %: 2.36 standard errors for 8, 2.13 for 16). With sobol, "
      "replicates make the image slightly noisier.");
  options
      .number("--reuse", a.reuse, 1, PixelGroups::kMaxEdge,
              fmt::format(
                  "Let groups of N x N pixels share their paths after the first bounce: 1 (no "
                  "sharing), 2, 4, 8 or 16. The image stays unbiased and --variance stays right "
                  "for each pixel, but the errors of pixels less than {} apart ({} for N = 4) are "
                  "correlated, so the mean of a region is less accurate than that of as many "
                  "independent pixels (N = 1).",
                  PixelGroups::tile_edge(a.reuse), PixelGroups::tile_edge(4)))
      ->check(check_power_of_two);
  options
      .value("--light-sampling", a.light_sampling, "NAME",
             "Method for direct light: " + alternatives(direct_method_names()) +
                 " (described below). Default: taken from the scene file.")
      ->check(one_of(direct_method_names()));
  add_line_rays_option(options, a);
  add_path_options(options, a);
  options.number("--seed", a.seed, 0, UINT64_MAX, "Seed of the random numbers.");
}

void add_check_options(OptionList& options, RenderArguments& a) {
  options.flag("--strict", a.strict,
               "Fail if input was repaired or dropped (exit code 3) or samples are not finite "
               "(exit code 1).");
  options.parsed(
      "--replay", "X,Y,SAMPLE", [&a](const std::string& text) { a.replay = parse_replay(text); },
      "Trace only this sample of this pixel and print the vertices of its path.");
}

}  // namespace

RenderArguments parse_render_arguments(const Arguments& arguments) {
  RenderArguments a;
  bool list_methods = false, version = false;
  OptionList options("Renders a scene by path tracing. The word render may be omitted.",
                     "Raytracing [render]");
  options.flag("--version", version, "Print version, build and libraries and exit.");
  options.flag("--list-methods", list_methods, "Print the methods for direct light and exit.");
  add_scene_option(options, a.scene);
  add_output_options(options, a);
  options.group("Image");
  add_size_options(options, a);
  options.group("Sampling");
  add_sampling_options(options, a);
  options.group("Execution");
  add_run_options(options, a);
  add_check_options(options, a);
  options.refuse_extra_with([&a](const std::string& argument) {
    if (is_word(a.scene) && !find_scene(a.scene))
      return a.scene + ": no such subcommand or scene file" + subcommand_hint(a.scene);
    return argument + ": one argument too many; the scene file is " + a.scene;
  });
  options.footer("\n" + subcommands_text() + "Methods for direct light:\n" + methods_text() +
                 "\nLayers of EXR images:\n" + layers_text());

  options.parse(arguments.values);
  if (list_methods) throw TextRequest{methods_text()};
  if (version) throw TextRequest{version_text()};
  if (a.variance) add_variance(a.layers);
  resolve_scene(a.scene, is_word(a.scene) ? subcommand_hint(a.scene) : "");
  for (const std::string& output : a.outputs) image_ending(output);
  return a;
}

RenderOptions render_options(const RenderArguments& a, const SceneFile& scene) {
  RenderOptions o;
  o.width = a.width.value_or(scene.width);
  o.height = a.height.value_or(scene.height);
  o.spp = a.spp.value_or(static_cast<std::uint64_t>(scene.spp));
  o.replicates = a.replicates;
  if (o.spp % o.replicates != 0)
    throw UsageError(
        fmt::format("--replicates: {} does not divide {} samples per pixel", o.replicates, o.spp));
  o.reuse = a.reuse;
  const std::string method = a.light_sampling.value_or(scene.light_sampling);
  o.path.method = find_direct_method(method);
  if (!o.path.method)  // the default of scene files is no longer in the table of methods
    throw UsageError("--light-sampling: there is no method " + method);
  o.path.max_depth = a.max_depth;
  o.path.line_rays = a.line_rays;
  o.sampler = a.sampler;
  o.seed = a.seed;
  o.threads = a.threads;
  o.layers = a.layers;
  return o;
}

}  // namespace raytracing
