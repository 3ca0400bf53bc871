#include "chart_options.h"

#include <fmt/format.h>

#include <set>

#include "limits.h"
#include "method_list.h"
#include "option_list.h"
#include "raytracing/study/error_metrics.h"

namespace raytracing {
namespace {

constexpr std::uint64_t kMaxSeeds = std::uint64_t{1} << 20;  // see run_seed()

std::vector<std::uint64_t> parse_spp(const std::string& text) {
  std::set<std::uint64_t> numbers;
  for (const std::string& part : split_list(text))
    if (!numbers.insert(whole_number("--spp", part, 1, kMaxSpp)).second)
      throw_usage("--spp: " + part + " is named twice");
  return {numbers.begin(), numbers.end()};
}

// Fills `a`.
struct ChartOptionList : OptionList {
  ChartArguments& a;

  explicit ChartOptionList(ChartArguments& arguments)
      : OptionList(
            "Measures the error of the methods against their time, and draws it. The same "
            "command goes on where an earlier run of it was stopped. No paths are shared "
            "between pixels, as in renderings with --reuse 1.",
            "Raytracing chart"),
        a(arguments) {
    add_text("--scene,scene", a.scene, "FILE.toml", "Scene file (TOML)");
    add_text("--out", a.folder, "DIR",
             "Folder for tables, charts, report.html, and in runs/ the picture of every run (12 "
             "bytes a pixel at most)");
    add_run_options();
    add_reference_options();
    add_picture_options();
    refuse_extra_with([this] { return "one scene file is enough, and it is " + a.scene; });
    add_footer("Errors are relMSE = " + relmse_formula() + " over pixels and channels.\n");
  }

  void add_run_options() {
    add_parsed(
        "--methods", "A,B,...",
        [this](const std::string& text) { a.methods = parse_methods(text); },
        "Light sampling methods, of " + alternatives(direct_method_names()) + "; default all");
    add_parsed(
        "--spp", "N,N,...", [this](const std::string& text) { a.spp = parse_spp(text); },
        "Samples per pixel; default 1,2,4,8,16,32,64");
    add_number("--seeds", a.seeds, 1, kMaxSeeds,
               fmt::format("Runs of each method at each spp, with a seed each; default {}; the "
                           "bias needs two",
                           a.seeds));
  }

  void add_reference_options() {
    add_text("--reference", a.reference, "FILE|auto",
             "Picture that errors are measured against, an EXR; default auto: rendered with "
             "seeds of its own, in two halves that tell its noise, and kept in DIR. A file's "
             "noise is known when auto made it, or from --variance --reuse 1 with --sampler "
             "independent or --replicates");
    add_real("--reference-time", a.reference_time, 0.001, 1e9,
             fmt::format("Seconds to render it for; default {:g}", a.reference_time));
    add_text("--mask", a.mask, "FILE",
             "Picture of the same size, white where pixels count; default all");
  }

  void add_picture_options() {
    add_number("--width", a.width, 1, kMaxImageSize,
               "Picture width in pixels; default: the scene's; 256 is enough for most charts");
    add_number("--height", a.height, 1, kMaxImageSize,
               "Picture height in pixels; default: the scene's");
    add_number("--max-depth", a.max_depth, 1, kMaxDepth,
               "Surfaces that a path may be reflected at; 1 = direct light only; default "
               "unlimited");
    add_number(
        "--line-rays", a.line_rays, 1, kMaxLineRays,
        fmt::format("Rays per chord of the methods that count rays; default {}", a.line_rays));
    add_choice(
        "--sampler", {"sobol", "independent"},
        [this](const std::string& name) { a.sampler = *sampler_kind(name); },
        "Source of the random numbers: sobol (default) or independent");
    add_number("--threads", a.threads, 1, kMaxThreads,
               "Threads; default: as many as the machine has");
    add_choice(
        "--progress", {"auto", "bar", "jsonl", "none"},
        [this](const std::string& name) { a.progress = *progress_style(name); },
        "How progress is shown on stderr: auto (default; a bar on a terminal, else "
        "nothing), bar, jsonl (one JSON object per line) or none");
    add_switch("--quiet", a.quiet, "Print nothing but errors and warnings");
  }
};

}  // namespace

ChartArguments parse_chart_arguments(const Arguments& arguments) {
  ChartArguments a;
  a.methods = all_methods();
  a.threads = default_threads();
  ChartOptionList options(a);
  a.text = options.parse(arguments);
  if (a.text) return a;
  if (a.scene.empty()) throw_usage("no scene file given");
  if (a.folder.empty()) throw_usage("--out: no folder given");
  return a;
}

}  // namespace raytracing
