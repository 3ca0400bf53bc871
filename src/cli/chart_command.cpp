#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "build_info.h"
#include "chart_options.h"
#include "commands.h"
#include "raytracing/cli/app.h"
#include "raytracing/io/errors.h"
#include "raytracing/study/chart/chart.h"
#include "raytracing/study/chart_runs.h"
#include "result_folder.h"
#include "scene_notes.h"
#include "signals.h"

namespace raytracing {
namespace {

ChartRequest chart_request(const ChartArguments& a, const SceneFile& file,
                           const std::string& command_line) {
  ChartRequest request;
  ChartSettings& s = request.settings;
  s.folder = a.folder;
  s.scene_path = a.scene;
  s.scene_hash = file.hash;
  s.width = a.width.value_or(file.width);
  s.height = a.height.value_or(file.height);
  s.max_depth = a.max_depth;
  s.sampler = a.sampler;
  s.line_rays = a.line_rays;
  s.threads = a.threads;
  s.methods = a.methods;
  s.spp = a.spp;
  s.seeds = a.seeds;
  s.made_by = {{"software", "Raytracing " + program_version()},
               {"build", build_description()},
               {"program", program_hash()},
               {"machine", machine_description()},
               {"argv", command_line}};
  request.reference = a.reference;
  request.reference_seconds = a.reference_time;
  request.mask = a.mask;
  request.facts = {{"command", command_line},
                   {"version", program_version()},
                   {"build", build_description()},
                   {"machine", machine_description()}};
  return request;
}

/// Shows the making of a chart on the terminal.
class ChartDisplay : public ChartListener {
 public:
  explicit ChartDisplay(const ChartArguments& a)
      : quiet_(a.quiet),
        style_(a.quiet ? ProgressStyle::none : a.progress),
        folder_(a.folder, a.quiet) {}

  void note(const std::string& line) override {
    if (!quiet_) fmt::print(stderr, "{}\n", line);
  }
  void warn(const std::string& line) override {
    fmt::print(stderr, "warning: {}\n", one_line(line));
  }
  void file_written(const std::string& name) override { folder_.print_path(name); }
  void progress_began() override { progress_.emplace(style_); }
  void progress(std::uint64_t done, std::uint64_t total) override {
    progress_->update(done, total);
  }
  void progress_ended(bool complete) override { progress_->finish(complete); }

 private:
  bool quiet_;
  ProgressStyle style_;
  ResultFolder folder_;
  std::optional<ProgressDisplay> progress_;
};

int exit_code(ChartEnd end, int signal) {
  if (end == ChartEnd::complete) return kExitGood;
  fmt::print(stderr, "stopped: {}\n",
             end == ChartEnd::stopped_in_runs
                 ? "finished runs are kept; the same command goes on"
                 : "before the reference was complete: the same command begins it anew");
  return kExitSignalBase + signal;
}

}  // namespace

int chart_command(const Arguments& arguments) {
  const ChartArguments a = parse_chart_arguments(arguments);
  if (a.text) {
    fmt::print("{}", *a.text);
    return kExitGood;
  }
  LoadReport report;
  SceneFile file = load_scene_file(a.scene, direct_method_names(), report);
  print_load_report(report, file, a.quiet, false);
  const ChartRequest request = chart_request(a, file, arguments.command_line);
  const StopOnSignal signals;
  const auto asks_segments = [](const DirectMethod* m) { return m->asks_segments; };
  const bool segments = asks_segments(&reference_method(a.max_depth)) ||
                        std::any_of(a.methods.begin(), a.methods.end(), asks_segments);
  bring_near(file.scene);
  warn_of_narrow_pixels(file.scene.camera, request.settings.height);
  const Scene scene(std::move(file.scene), a.threads, segments);
  print_scene_notes(scene, a.quiet, false);
  ChartDisplay display(a);
  return exit_code(make_chart(scene, request, signals.stop(), display), signals.signal());
}

}  // namespace raytracing
