#include "raytracing/study/chart/chart.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "app.h"
#include "build_info.h"
#include "common_options.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/image_library.h"
#include "raytracing/sampling/sampler.h"
#include "raytracing/study/chart/runs.h"
#include "raytracing/study/metrics/error_metrics.h"
#include "scene_input.h"

namespace raytracing {
namespace {

constexpr std::uint64_t kMaxSeeds = std::uint64_t{1} << 20;  // see run_seed()

struct ChartArguments : SceneArguments {
  ChartRequest request;
};

void add_measurement_options(OptionList& options, ChartRequest& request) {
  ChartSettings& s = request.settings;
  s.spp = {1, 2, 4, 8, 16, 32, 64};
  add_methods_option(options, s.methods);
  options.list(
      "--spp", s.spp, "N,N,...",
      [](const std::string& text) {
        return std::uint64_t{std::stoull(checked("--spp", text, whole_number(1, kMaxSpp)))};
      },
      fmt::format("Sample counts per pixel. Default: {}.", fmt::join(s.spp, ",")));
  options.number(
      "--seeds", s.seeds, 1, kMaxSeeds,
      "Runs of each method at each sample count, each with a seed of its own; at least 2 "
      "are needed to estimate bias.");
  options.value("--reference", request.reference, "FILE|auto",
                "Reference image of floats, EXR for example. With auto, it is rendered with seeds "
                "of its own and "
                "kept in DIR, in two halves from which its noise is estimated. The noise of other "
                "files is known if they were rendered with --variance --reuse 1 and either "
                "--sampler independent or --replicates. Default: auto.");
  options.real("--reference-time", request.reference_seconds, 0.001, 1e9,
               "Seconds to spend on rendering the reference.");
  add_mask_option(options, request.mask);
}

ChartArguments parse_chart_arguments(const Arguments& arguments) {
  ChartArguments a;
  ChartSettings& s = a.request.settings;
  OptionList options(
      "Measures the error of the direct-light methods over render time and over sample count, and "
      "plots it. A repeated command continues where the previous run was stopped. Pixels share no "
      "paths, as with render --reuse 1.",
      "Raytracing chart");
  add_scene_option(options, a.scene);
  options.value(
      "--out", s.folder, "DIR",
      "Folder for tables, charts and report.html. Its subfolder runs keeps the image of every "
      "run, with at most 12 bytes per pixel.");
  options.group("Measurement");
  add_measurement_options(options, a.request);
  options.group("Image");
  add_size_options(options, a);
  options.group("Sampling");
  add_line_rays_option(options, a);
  add_path_options(options, a);
  options.group("Execution");
  add_run_options(options, a);
  options.footer(
      "\nA size of 256 x 256 pixels suffices for most charts.\nErrors are given as relMSE = " +
      relmse_formula() + " over pixels and channels.\n");
  options.parse(arguments.values);
  std::sort(s.spp.begin(), s.spp.end());
  resolve_scene(a.scene);
  if (s.folder.empty()) throw_usage("--out: no folder given");
  return a;
}

// Completes the settings of the command line from the scene file.
ChartRequest chart_request(const ChartArguments& a, const SceneFile& file,
                           const std::string& command_line) {
  ChartRequest request = a.request;
  ChartSettings& s = request.settings;
  s.scene_path = a.scene;
  s.scene_hash = file.hash;
  s.width = a.width.value_or(file.width);
  s.height = a.height.value_or(file.height);
  s.max_depth = a.max_depth;
  s.sampler = a.sampler;
  s.line_rays = a.line_rays;
  s.threads = a.threads;
  s.made_by = program_facts();
  s.made_by.program = program_hash();
  s.made_by.command = command_line;
  return request;
}

/// Shows the making of a chart on the terminal.
class ChartDisplay : public ChartListener {
 public:
  explicit ChartDisplay(const ChartArguments& a) : a_(a) {}

  void note(const std::string& line) override {
    if (!a_.quiet) print_message("{}\n", line);
  }
  void warn(const std::string& line) override { print_message("warning: {}\n", one_line(line)); }
  void file_written(const std::string& name) override {
    if (!a_.quiet) fmt::print("{}/{}\n", a_.request.settings.folder, name);
  }
  void progress_began() override { progress_.emplace(a_.shown_progress()); }
  void progress(std::uint64_t done, std::uint64_t total) override {
    progress_->update(done, total);
  }
  void progress_ended(bool complete) override { progress_->finish(complete); }

 private:
  const ChartArguments& a_;
  std::optional<ProgressDisplay> progress_;
};

int exit_code(ChartEnd end, int signal) {
  if (end == ChartEnd::complete) return kExitGood;
  print_message("stopped: {}\n",
                end == ChartEnd::stopped_in_runs
                    ? "finished runs are kept; repeat the command to continue"
                    : "the reference is incomplete; repeat the command to render it anew");
  return kExitSignalBase + signal;
}

}  // namespace

int chart_command(const Arguments& arguments) {
  const ChartArguments a = parse_chart_arguments(arguments);
  SceneInput input(a.scene, a.quiet, false);
  image_library();  // which would disturb the first measurement if it were loaded then
  const ChartRequest request = chart_request(a, input.file(), arguments.command_line);
  const StopOnSignal signals;
  const auto asks_segments = [](const DirectMethod* m) { return m->asks_segments; };
  const auto& methods = request.settings.methods;
  const bool segments = asks_segments(&reference_method(a.max_depth)) ||
                        std::any_of(methods.begin(), methods.end(), asks_segments);
  const Scene& scene = input.build(request.settings.height, a.threads, segments);
  ChartDisplay display(a);
  const ChartEnd end = make_chart(scene, request, signals.stop(), display);
  return exit_code(end, signals.signal());
}

}  // namespace raytracing
