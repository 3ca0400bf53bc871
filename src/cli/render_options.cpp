#include "render_options.h"

#include <fmt/format.h>

#include <bit>
#include <filesystem>
#include <system_error>

#include "build_info.h"
#include "limits.h"
#include "option_list.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/image_file.h"
#include "raytracing/render/pixel_groups.h"

namespace raytracing {
namespace {

std::string methods_text() {
  std::string text;
  for (const DirectMethod& m : direct_methods())
    text += fmt::format("{:<12} {}: {}; costs {}\n", m.name, m.unbiased ? "unbiased" : "BIASED",
                        m.summary, m.cost);
  return text;
}

RenderArguments::Replay parse_replay(const std::string& text) {
  const std::size_t first = text.find(','), last = text.rfind(',');
  if (first == last) throw UsageError("--replay: '" + text + "' is not X,Y,SAMPLE");
  const auto number = [&](std::size_t from, std::size_t to, std::uint64_t high) {
    return whole_number("--replay", std::string_view(text).substr(from, to - from), 0, high);
  };
  return {static_cast<int>(number(0, first, kMaxImageSize - 1)),
          static_cast<int>(number(first + 1, last, kMaxImageSize - 1)),
          number(last + 1, text.size(), kMaxSpp - 1)};
}

// A word that names no file may be meant as a subcommand. What is wrong with it, or "".
std::string fault_of_scene_name(const std::string& name) {
  std::error_code error;  // of names that cannot be
  if (name.find_first_of("./") != std::string::npos || std::filesystem::exists(name, error))
    return "";
  return fmt::format("{}: no such scene file or subcommand; the nearest subcommand is {}", name,
                     nearest_subcommand(name));
}

// Fills `a`, and the two switches that ask for texts.
struct RenderOptionList : OptionList {
  RenderArguments& a;
  bool list_methods = false;
  bool version = false;

  explicit RenderOptionList(RenderArguments& arguments)
      : OptionList("Renders a scene to pictures. The word render may be left out.",
                   "Raytracing [render]"),
        a(arguments) {
    add_text("--scene,scene", a.scene, "FILE.toml", "Scene file (TOML)");
    add_picture_options();
    add_sampling_options();
    add_report_options();
    refuse_extra_with([this] {
      const std::string fault = fault_of_scene_name(a.scene);
      return fault.empty() ? "one scene file is enough, and it is " + a.scene : fault;
    });
    add_footer(subcommands_text());
    add_footer("Light sampling methods:\n" + methods_text());
  }

  void add_picture_options() {
    add_texts("-o,--output", a.outputs, "FILE",
              "Picture to write, .png (sRGB, 8 bit) or .exr (linear, float32); repeatable; "
              "default <scene>.png in the working directory");
    add_number("--width", a.width, 1, kMaxImageSize,
               "Picture width in pixels; default: the scene's");
    add_number("--height", a.height, 1, kMaxImageSize,
               "Picture height in pixels; default: the scene's");
    add_switch("--variance", a.variance,
               "Add the layers variance.R/G/B, variance of the pixel mean, to an EXR. Without "
               "--replicates it takes the samples as independent: right with --sampler "
               "independent, too large with sobol");
  }

  void add_sampling_options() {
    add_number("--spp", a.spp, 1, kMaxSpp, "Samples per pixel; default: the scene's");
    add_number("--replicates", a.replicates, 1, kMaxReplicates,
               "Take the samples of each pixel in N groups, each scrambled by its own random "
               "numbers; N divides --spp; default 1. With 2 or more (8 or 16 are good) --variance "
               "is that between the group means over N, which is honest for sobol too; a 95 % "
               "interval takes Student's t with N-1 degrees of freedom (2.36 for 8, 2.13 for 16). "
               "The picture is a little noisier with sobol than without");
    add_parsed(
        "--reuse", "N",
        [this](const std::string& text) {
          a.reuse = static_cast<int>(whole_number("--reuse", text, 1, PixelGroups::kMaxEdge));
          if (!std::has_single_bit(static_cast<unsigned>(a.reuse)))
            throw UsageError("--reuse: " + text + " is not 1, 2, 4, 8 or 16");
        },
        fmt::format("Groups of N x N pixels share their paths after the first bounce: 1 "
                    "(none), 2, 4, 8 or 16; default {}. Unbiased, and --variance stays "
                    "right for each pixel; but errors of pixels less than {} apart ({} "
                    "with 4) are alike, so means over regions are less sure than as many "
                    "independent pixels (--reuse 1)",
                    a.reuse, PixelGroups::tile_edge(a.reuse), PixelGroups::tile_edge(4)));
    add_choice(
        "--light-sampling", direct_method_names(),
        [this](const std::string& name) { a.light_sampling = name; },
        "How direct light is sampled: " + alternatives(direct_method_names()) +
            " (see below); default: the scene's");
    add_number(
        "--line-rays", a.line_rays, 1, kMaxLineRays,
        fmt::format("Rays per chord of the methods that count rays; default {}", a.line_rays));
    add_number("--max-depth", a.max_depth, 1, kMaxDepth,
               "Surfaces that a path may be reflected at; 1 = direct light only; default "
               "unlimited, with Russian roulette");
    add_number("--seed", a.seed, 0, UINT64_MAX, "Seed of the random numbers; default 0");
    add_choice(
        "--sampler", {"sobol", "independent"},
        [this](const std::string& name) { a.sampler = *sampler_kind(name); },
        "Source of the random numbers: sobol (default) or independent");
    add_number("--threads", a.threads, 1, kMaxThreads,
               "Threads; default: as many as the machine has. The picture does not depend on it");
  }

  void add_report_options() {
    add_text("--stats", a.stats, "FILE.json", "Write statistics as JSON");
    add_choice(
        "--progress", {"auto", "bar", "jsonl", "none"},
        [this](const std::string& name) { a.progress = *progress_style(name); },
        "How progress is shown on stderr: auto (default; a bar on a terminal, else "
        "nothing), bar, jsonl (one JSON object per line) or none");
    add_switch("--quiet", a.quiet,
               "Print nothing but errors and warnings: no progress, no summary, no file names");
    add_switch("--strict", a.strict,
               "Repaired or dropped input is an error (exit code 3), and so are non-finite "
               "samples (exit code 1)");
    add_parsed(
        "--replay", "X,Y,SAMPLE",
        [this](const std::string& text) { a.replay = parse_replay(text); },
        "Trace only this sample of this pixel and print its vertices");
    add_switch("--list-methods", list_methods, "List the values of --light-sampling");
    add_switch("--version", version, "Version, build, instruction set and libraries");
  }
};

}  // namespace

RenderArguments parse_render_arguments(const Arguments& arguments) {
  RenderArguments a;
  a.threads = default_threads();
  RenderOptionList options(a);
  a.text = options.parse(arguments);
  if (a.text) return a;
  if (options.list_methods) a.text = methods_text();
  if (options.version) a.text = version_text();
  if (a.text) return a;
  if (a.scene.empty()) throw_usage("no scene file given");
  const std::string fault = fault_of_scene_name(a.scene);
  if (!fault.empty()) throw InputError(fault);
  for (const std::string& output : a.outputs) image_format(output);
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
  o.shade.method =
      find_direct_method(a.light_sampling.empty() ? scene.light_sampling : a.light_sampling);
  o.shade.max_depth = a.max_depth;
  o.shade.line_rays = a.line_rays;
  o.sampler = a.sampler;
  o.seed = a.seed;
  o.threads = a.threads;
  return o;
}

}  // namespace raytracing
