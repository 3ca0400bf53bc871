#include "render_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <thread>

#include "build_info.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/image_file.h"

namespace raytracing {
namespace {

constexpr int kMaxImageSize = 65536;
constexpr std::uint64_t kMaxSpp = std::uint64_t{1} << 40;
constexpr int kMaxThreads = 1024;
constexpr int kMaxLineRays = 65536;

std::string methods_text() {
  std::string text;
  for (const DirectMethod& m : direct_methods())
    text += fmt::format("{:<12} {}: {}; costs {}\n", m.name, m.unbiased ? "unbiased" : "BIASED",
                        m.summary, m.cost);
  return text;
}

int default_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

RenderArguments::Replay parse_replay(const std::string& text) {
  RenderArguments::Replay replay{};
  int end = 0;
  if (std::sscanf(text.c_str(), "%d,%d,%lu%n", &replay.x, &replay.y, &replay.sample, &end) != 3 ||
      static_cast<std::size_t>(end) != text.size() || text.find('-') != std::string::npos)
    throw UsageError("--replay: '" + text + "' is not X,Y,SAMPLE");
  return replay;
}

// The one list of options: parsing and help both come from it.
struct OptionList {
  CLI::App app{"Renders a scene to pictures. `render` may be left out.", "Raytracing render"};
  RenderArguments& a;
  std::string replay;
  std::string sampler = "sobol";
  std::string progress = "auto";
  bool list_methods = false;
  bool version = false;

  explicit OptionList(RenderArguments& arguments) : a(arguments) {
    app.set_help_flag("-h,--help", "This text");
    app.add_option("--scene,scene", a.scene, "Scene file (TOML)")->type_name("FILE.toml");
    add_picture_options();
    add_sampling_options();
    add_report_options();
  }

  void add_picture_options() {
    app.add_option("-o,--output", a.outputs,
                   "Picture to write, .png (sRGB, 8 bit) or .exr (linear, float32); repeatable; "
                   "default <scene>.png")
        ->type_name("FILE")
        ->take_all()
        ->expected(1);
    app.add_option("--width", a.width, "Picture width in pixels; default: the scene's")
        ->check(CLI::Range(1, kMaxImageSize));
    app.add_option("--height", a.height, "Picture height in pixels; default: the scene's")
        ->check(CLI::Range(1, kMaxImageSize));
    app.add_flag("--variance", a.variance,
                 "Add the layers variance.R/G/B, sample variance of the pixel mean, to an EXR. It "
                 "takes the samples as independent: with --sampler sobol it is too large");
  }

  void add_sampling_options() {
    app.add_option("--spp", a.spp, "Samples per pixel; default: the scene's")
        ->check(CLI::Range(std::uint64_t{1}, kMaxSpp));
    app.add_option("--light-sampling", a.light_sampling,
                   "How direct light is sampled; default: the scene's; see --list-methods")
        ->check(CLI::IsMember(direct_method_names()));
    app.add_option("--line-rays", a.line_rays, "Rays per chord of the methods that count rays")
        ->check(CLI::Range(1, kMaxLineRays))
        ->capture_default_str();
    app.add_option("--max-depth", a.max_depth,
                   "Surfaces that a path may be reflected at; 1 = direct light only; default "
                   "unlimited, with Russian roulette")
        ->check(CLI::Range(1u, 1u << 30));
    app.add_option("--seed", a.seed, "Seed of the random numbers")->capture_default_str();
    app.add_option("--sampler", sampler, "Source of the random numbers")
        ->check(CLI::IsMember({"sobol", "independent"}))
        ->capture_default_str();
    app.add_option("--threads", a.threads,
                   "Threads; default: as many as the machine has. The picture does not depend on it")
        ->check(CLI::Range(1, kMaxThreads));
  }

  void add_report_options() {
    app.add_option("--stats", a.stats, "Write statistics as JSON")->type_name("FILE.json");
    app.add_option("--progress", progress,
                   "How progress is shown on stderr; auto = a bar on a terminal")
        ->check(CLI::IsMember({"auto", "bar", "jsonl", "none"}))
        ->capture_default_str();
    app.add_flag("--quiet", a.quiet, "No progress and no summary; errors and warnings still come");
    app.add_flag("--strict", a.strict,
                 "Repaired or dropped input is an error (exit code 3), and so are non-finite "
                 "samples (exit code 1)");
    app.add_option("--replay", replay,
                   "Trace only this sample of this pixel and print its vertices")
        ->type_name("X,Y,SAMPLE");
    app.add_flag("--list-methods", list_methods, "List the values of --light-sampling");
    app.add_flag("--version", version, "Version, build, instruction set and libraries");
  }

  std::string help() const { return app.help() + "\nLight sampling methods:\n" + methods_text(); }
};

// The first line only: CLI11 explains at length.
[[noreturn]] void throw_usage(const std::string& what) {
  throw UsageError(what.substr(0, what.find('\n')) + " (--help lists all options)");
}

}  // namespace

RenderArguments parse_render_arguments(const Arguments& arguments) {
  RenderArguments a;
  a.threads = default_threads();
  OptionList options(a);
  try {
    options.app.parse(std::vector<std::string>(arguments.values.rbegin(), arguments.values.rend()));
  } catch (const CLI::CallForHelp&) {
    a.text = options.help();
    return a;
  } catch (const CLI::ParseError& error) {
    throw_usage(error.what());
  }
  if (options.list_methods) a.text = methods_text();
  if (options.version) a.text = version_text();
  if (a.text) return a;
  if (a.scene.empty()) throw_usage("no scene file given");
  a.sampler = *sampler_kind(options.sampler);
  a.progress = *progress_style(options.progress);
  if (!options.replay.empty()) a.replay = parse_replay(options.replay);
  for (const std::string& output : a.outputs) image_format(output);
  return a;
}

RenderOptions render_options(const RenderArguments& a, const SceneFile& scene) {
  RenderOptions o;
  o.width = a.width.value_or(scene.width);
  o.height = a.height.value_or(scene.height);
  o.spp = a.spp.value_or(static_cast<std::uint64_t>(scene.spp));
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
