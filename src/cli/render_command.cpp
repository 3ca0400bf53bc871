#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "commands.h"
#include "output_paths.h"
#include "raytracing/cli/app.h"
#include "raytracing/io/file.h"
#include "render_options.h"
#include "render_outputs.h"
#include "replay.h"
#include "scene_notes.h"
#include "signals.h"

namespace raytracing {
namespace {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// All files that the run will write, opened before any work is done.
struct Outputs {
  std::vector<OutputFile> pictures;
  std::optional<OutputFile> stats;

  Outputs(const RenderArguments& a, const SceneFile& file) {
    std::vector<std::string> names = a.outputs;
    if (names.empty()) names.push_back(std::filesystem::path(a.scene).stem().string() + ".png");
    std::vector<std::string> inputs = file.assets, all = names;
    inputs.push_back(a.scene);
    all.push_back(a.stats);
    check_distinct(inputs, all);
    for (const std::string& name : names) pictures.emplace_back(name);
    if (!a.stats.empty()) stats.emplace(a.stats);
    const auto is_exr = [](const std::string& name) {
      return image_format(name) == ImageFormat::exr;
    };
    if (a.variance && std::none_of(names.begin(), names.end(), is_exr))
      fmt::print(stderr, "warning: --variance: no .exr among the outputs to hold it\n");
  }

  void write(const RenderRecord& record, bool variance, bool quiet) {
    const ImageData image = to_image(record, variance);
    for (OutputFile& file : pictures) {
      file.write(encode_image(image, image_format(file.path())));
      file.commit();
      if (!quiet) fmt::print("{}\n", file.path());
    }
    if (!stats) return;
    stats->write(stats_json(record));
    stats->commit();
  }
};

void print_result(const RenderRecord& r, bool quiet) {
  const RenderOptions& o = r.options;
  const DirectMethod& method = *o.shade.method;
  if (!quiet)
    fmt::print(stderr, "{}x{}, {} spp, {}{}, {} threads: {:.2f} s, {:.2f} million paths/s\n",
               o.width, o.height, o.spp, method.name, method.unbiased ? "" : " (biased)",
               r.result.threads, r.result.render_seconds,
               1e-6 * static_cast<double>(r.result.paths) / r.result.render_seconds);
  if (r.result.threads < o.threads)
    fmt::print(stderr, "warning: the system allows only {} of {} threads\n", r.result.threads,
               o.threads);
  for (const NonFiniteSample& s : r.result.first_non_finite)
    fmt::print(stderr, "non-finite sample ({}): the same command with --replay {},{},{} shows it\n",
               to_string(s.cause), s.x, s.y, s.sample);
  if (r.result.non_finite_samples > 0)
    fmt::print(stderr, "warning: {} of {} samples were not finite; they count as black\n",
               r.result.non_finite_samples, r.result.paths);
  if (!r.result.complete)
    fmt::print(stderr, "stopped early: {} of {} samples taken; the picture is incomplete\n",
               r.result.paths,
               o.spp * static_cast<std::uint64_t>(o.width) * static_cast<std::uint64_t>(o.height));
}

int render_and_write(const RenderArguments& a, const RenderOptions& options, const SceneFile& file,
                     const Scene& scene, const std::string& command_line, double load_seconds,
                     double build_seconds, const StopOnSignal& signals, Outputs& outputs) {
  ProgressDisplay display(a.quiet ? ProgressStyle::none : a.progress);
  const RenderResult result =
      render(scene, options, signals.stop(),
             [&](std::uint64_t done, std::uint64_t total) { display.update(done, total); });
  if (result.paths == 0) {  // nothing to keep, and an older picture is better than a black one
    fmt::print(stderr, "stopped before the first sample: nothing written\n");
    return kExitSignalBase + signals.signal();
  }
  const RenderRecord record{a.scene,      file,         options,      result,
                            command_line, load_seconds, build_seconds};
  outputs.write(record, a.variance, a.quiet);
  display.finish(result.complete);
  print_result(record, a.quiet);
  if (signals.signal() != 0) return kExitSignalBase + signals.signal();
  return a.strict && result.non_finite_samples > 0 ? kExitCheckFailed : kExitGood;
}

}  // namespace

int render_command(const Arguments& arguments) {
  const RenderArguments a = parse_render_arguments(arguments);
  if (a.text) {
    fmt::print("{}", *a.text);
    return kExitGood;
  }
  const Stopwatch load_time;
  LoadReport report;
  SceneFile file = load_scene_file(a.scene, direct_method_names(), report);
  const double load_seconds = load_time.seconds();
  print_load_report(report, file, a.quiet, a.strict);

  const StopOnSignal signals;  // before there are temporary files to leave behind
  const RenderOptions options = render_options(a, file);
  std::optional<Outputs> outputs;
  if (!a.replay) outputs.emplace(a, file);
  const Stopwatch build_time;
  const Vec3 origin = bring_near(file.scene);
  warn_of_narrow_pixels(file.scene.camera, options.height);
  const Scene scene(std::move(file.scene), a.threads,
                    options.shade.method->asks_segments || shares_paths(options));
  const double build_seconds = build_time.seconds();
  print_scene_notes(scene, a.quiet, a.strict);
  if (a.replay) {
    fmt::print("{}", replay_text(scene, options, *a.replay, origin));
    return kExitGood;
  }
  return render_and_write(a, options, file, scene, arguments.command_line, load_seconds,
                          build_seconds, signals, *outputs);
}

}  // namespace raytracing
