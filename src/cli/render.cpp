#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app.h"
#include "build_info.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/io/film_image.h"
#include "raytracing/io/image.h"
#include "raytracing/io/image_library.h"
#include "raytracing/render/provenance.h"
#include "render_options.h"
#include "scene_input.h"
#include "terminal.h"

namespace raytracing {
namespace {

// All files that the run will write, created before any work is done, and the library that writes
// them.
class Outputs {
 public:
  Outputs(const RenderArguments& a, const SceneFile& file) : as_float_(a.as_float) {
    std::vector<std::string> names = a.outputs;
    if (names.empty()) names.push_back(std::filesystem::path(a.scene).stem().string() + ".png");
    std::vector<std::string> inputs = file.assets, all = names;
    inputs.push_back(a.scene);
    all.push_back(a.stats);
    check_distinct(inputs, all);
    for (const std::string& name : names) images_.emplace_back(name);
    if (!a.stats.empty()) stats_.emplace(a.stats);
    const auto any = [&](const std::string& ending) {
      return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return image_ending(name).starts_with(ending);
      });
    };
    if (!a.layers.empty() && !any("exr"))
      print_message("warning: {} has no effect: no output is an .exr file\n",
                    a.variance && a.layers.size() == 1 ? "--variance" : "--layers");
    if (as_float_ && !any("tif"))
      print_message("warning: --float has no effect: no output is a .tif file\n");
    for (const std::string& name : names)
      if (!holds_metadata(image_ending(name)))
        print_message("warning: {}: .{} files cannot carry the facts of the rendering\n", name,
                      image_ending(name));
  }

  /// Finds out during the rendering, not behind it, that no image could be written.
  void check() const { library_.check(); }

  /// Writes all that can be written. Throws the first error only then; others are printed.
  void write(const RenderResult& result, const RunFacts& facts, bool quiet) {
    const ImageData image = to_image(result.film, facts, result.layers);
    std::exception_ptr first;
    const auto attempt = [&first](const auto& step) {
      try {
        step();
      } catch (const std::exception& error) {
        if (first) print_message("Raytracing: {}\n", one_line(error.what()));
        if (!first) first = std::current_exception();
      }
    };
    for (OutputFile& file : images_)
      attempt([&] {
        file.write(encode_image(image, image_ending(file.path()), as_float_));
        file.commit();
        if (!quiet) fmt::print("{}\n", file.path());
      });
    attempt([&] {
      if (!stats_) return;
      stats_->write(to_json(facts).dump(2) + "\n");
      stats_->commit();
    });
    if (first) std::rethrow_exception(first);
  }

 private:
  ImageLibraryPreload library_;
  bool as_float_;
  std::vector<OutputFile> images_;
  std::optional<OutputFile> stats_;
};

void print_summary(const RenderOptions& o, const RenderResult& r, bool quiet) {
  const DirectMethod& method = *o.path.method;
  if (!quiet)
    print_message("{}x{} pixels, {} spp, {}{}, {}: {:.2f} s, {:.2f} million paths/s\n", o.width,
                  o.height, o.spp, method.name, method.unbiased ? "" : " (biased)",
                  counted(r.threads, "thread"), r.render_seconds,
                  1e-6 * static_cast<double>(r.paths) / r.render_seconds);
  if (r.threads < o.threads)
    print_message("warning: the system allows only {} of {} threads\n", r.threads, o.threads);
  for (const NonFiniteSample& s : r.first_non_finite)
    print_message("non-finite sample ({}): add --replay {},{},{} to trace it again\n",
                  to_string(s.cause), s.index.x, s.index.y, s.index.sample);
  if (r.non_finite_samples > 0)
    print_message("warning: {} of {} samples were not finite and count as black\n",
                  r.non_finite_samples, r.paths);
  if (!r.complete)
    print_message(
        "stopped early: {} of {} samples taken; the image is incomplete\n", r.paths,
        o.spp * static_cast<std::uint64_t>(o.width) * static_cast<std::uint64_t>(o.height));
}

template <class V>
std::string to_text(const V& v) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
}

// Describes the vertices of one sample and what each contributes. Positions are those of the scene
// file.
std::string replay_text(const Scene& scene, const RenderOptions& options,
                        const RenderArguments::Replay& replay) {
  if (replay.x >= options.width || replay.y >= options.height || replay.sample >= options.spp)
    throw UsageError(fmt::format("--replay: {},{},{} lies outside {}x{} pixels and {} spp",
                                 replay.x, replay.y, replay.sample, options.width, options.height,
                                 options.spp));
  const auto& [radiance, log, counts] =
      trace_sample(scene, options, {replay.x, replay.y, replay.sample});
  std::string out =
      fmt::format("pixel {},{} sample {} seed {} {} {}\n", replay.x, replay.y, replay.sample,
                  options.seed, to_string(options.sampler), options.path.method->name);
  if (shares_paths(options))
    out += fmt::format(
        "groups of {0}x{0} pixels share paths: vertices with throughput 0 follow the first bounces "
        "of the other pixels of the group, and 'direct' is all light that this sample receives "
        "through them\n",
        options.reuse);
  for (std::size_t i = 0; i < log.steps.size(); ++i) {
    const PathLog::Step& s = log.steps[i];
    out += fmt::format(
        "vertex {} at {} normal {}\n  throughput {}\n  emitted {}{}\n  direct {}\n"
        "  continues with probability {:.9g}\n",
        i + 1, to_text(DVec3(s.position) + DVec3(scene.origin())), to_text(s.normal),
        to_text(s.throughput), to_text(s.emitted),
        s.light == kNone ? "" : fmt::format(" (light {})", s.light), to_text(s.direct), s.survival);
  }
  if (!is_finite(radiance))
    out += fmt::format("not finite: {}\n", to_string(non_finite_cause(log)));
  return out + fmt::format(
                   "radiance {}; {} closest-hit rays, {} shadow rays, {} segment queries, "
                   "{} shaft queries\n",
                   to_text(radiance), counts.closest, counts.shadow, counts.segments,
                   counts.shafts);
}

}  // namespace

int render_command(const Arguments& arguments) {
  const RenderArguments a = parse_render_arguments(arguments);
  SceneInput input(a.scene, a.quiet, a.strict);
  const StopOnSignal signals;  // before there are temporary files to leave behind
  const RenderOptions options = render_options(a, input.file());
  std::optional<Outputs> outputs;
  if (!a.replay) outputs.emplace(a, input.file());
  const Scene& scene = input.build(options.height, a.threads, needs_occluders(options));
  if (a.replay) {
    fmt::print("{}", replay_text(scene, options, *a.replay));
    return kExitGood;
  }
  ProgressDisplay display(a.shown_progress());
  const RenderResult result =
      render(scene, options, signals.stop(), [&](std::uint64_t done, std::uint64_t total) {
        outputs->check();
        display.update(done, total);
      });
  if (result.paths == 0) {  // nothing to keep, and an older image is better than a black one
    print_message("stopped before the first sample: nothing written\n");
    return kExitSignalBase + signals.signal();
  }
  RunFacts facts = program_facts();
  facts.command = arguments.command_line;
  facts.scene = a.scene;
  facts.scene_hash = hash_text(input.file().hash);
  facts.load_seconds = input.load_seconds();
  facts.build_seconds = input.build_seconds();
  facts.peak_rss_bytes = peak_rss_bytes();
  add_options(facts, options);
  add_result(facts, options, result);
  outputs->write(result, facts, a.quiet);
  display.finish(result.complete);
  print_summary(options, result, a.quiet);
  // A signal that came after the last sample has not stopped anything.
  if (!result.complete) return kExitSignalBase + signals.signal();
  return a.strict && result.non_finite_samples > 0 ? kExitCheckFailed : kExitGood;
}

}  // namespace raytracing
