#include "common_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <thread>

#include "raytracing/io/errors.h"
#include "raytracing/scene/description.h"
#include "scene_input.h"

namespace raytracing {
namespace {

constexpr int kMaxThreads = 1024;
constexpr int kMaxLineRays = 65536;
constexpr std::uint64_t kMaxDepth = std::uint64_t{1} << 30;

}  // namespace

RunArguments::RunArguments()
    : threads(std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

void add_scene_option(OptionList& options, std::string& scene) {
  options.value("--scene,scene", scene, "FILE",
                "Scene file in TOML format. A name without a directory is also looked up among the "
                "installed scenes, with or without its extension: cornell or cornell.toml.");
  options.refuse_extra_with([&scene](const std::string& argument) {
    return argument + ": one argument too many; the scene file is " + scene;
  });
}

void resolve_scene(std::string& scene, const std::string& hint) {
  if (scene.empty()) throw_usage("no scene file given");
  const std::vector<std::string> candidates = scene_candidates(scene);
  if (const auto found = find_scene(scene))
    scene = *found;
  else if (candidates.size() > 1)  // else opening the file reports the reason
    throw InputError(fmt::format("{}: no such scene file; looked for {}{}", scene,
                                 fmt::join(candidates, ", "), hint));
}

void add_size_options(OptionList& options, SceneArguments& a) {
  options.number("--width", a.width, 1, kMaxImageSize,
                 "Image width in pixels. Default: taken from the scene file.");
  options.number("--height", a.height, 1, kMaxImageSize,
                 "Image height in pixels. Default: taken from the scene file.");
}

void add_path_options(OptionList& options, SceneArguments& a) {
  options.number("--max-depth", a.max_depth, 1, kMaxDepth,
                 "Maximum number of surface reflections along a path; 1 renders direct light only. "
                 "Default: unlimited, with Russian roulette.");
  options.choice<SamplerKind>(
      "--sampler", a.sampler,
      {{"sobol", SamplerKind::sobol}, {"independent", SamplerKind::independent}},
      "Source of random numbers: sobol (Owen-scrambled Sobol' points) or independent (uniform "
      "random numbers). Default: sobol.");
}

void add_line_rays_option(OptionList& options, RunArguments& a) {
  options.number("--line-rays", a.line_rays, 1, kMaxLineRays,
                 "Number of shadow rays per chord, for the methods that estimate the visibility "
                 "of a chord with shadow rays.");
}

void add_methods_option(OptionList& options, std::vector<const DirectMethod*>& methods) {
  for (const DirectMethod& method : direct_methods()) methods.push_back(&method);
  options.list(
      "--methods", methods, "A,B,...",
      [](const std::string& name) {
        return find_direct_method(checked("--methods", name, one_of(direct_method_names())));
      },
      "Direct-light methods to measure: any of " + alternatives(direct_method_names()) +
          ". Default: all.");
}

void add_mask_option(OptionList& options, std::string& mask) {
  options.value("--mask", mask, "FILE",
                "Image of the same size that selects the pixels to measure: those where the mean "
                "of its linear R, G and B is at least 0.5. Default: all pixels.");
}

void add_run_options(OptionList& options, RunArguments& a) {
  options
      .value("--threads", a.threads, "N",
             "Number of threads; the computed values do not depend on it. Default: all hardware "
             "threads.")
      ->transform(whole_number(1, kMaxThreads));
  options.choice<ProgressStyle>("--progress", a.progress,
                                {{"auto", ProgressStyle::automatic},
                                 {"bar", ProgressStyle::bar},
                                 {"jsonl", ProgressStyle::jsonl},
                                 {"none", ProgressStyle::none}},
                                "Progress display on stderr: auto (a bar if stderr "
                                "is a terminal, otherwise none), bar, jsonl (one "
                                "JSON object per line) or none. Default: auto.");
  options.flag("--quiet", a.quiet,
               "Print only errors and warnings: no progress, no summary, no names of written "
               "files.");
}

void check_distinct(const std::vector<std::string>& inputs,
                    const std::vector<std::string>& outputs) {
  // A path that cannot be followed is reported when it is opened.
  const auto place = [](const std::string& path) {
    std::error_code error;
    const auto absolute = std::filesystem::absolute(path, error);
    const auto canonical = std::filesystem::weakly_canonical(absolute, error);
    return (error ? absolute : canonical).string();
  };
  std::set<std::string> taken;
  for (const std::string& input : inputs)
    if (!input.empty()) taken.insert(place(input));
  for (const std::string& output : outputs)
    if (!output.empty() && !taken.insert(place(output)).second)
      throw UsageError(output + ": would be overwritten: it is named twice");
}

}  // namespace raytracing
