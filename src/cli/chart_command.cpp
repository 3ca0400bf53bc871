#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "build_info.h"
#include "chart_options.h"
#include "commands.h"
#include "raytracing/cli/app.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/study/chart_plot.h"
#include "raytracing/study/chart_report.h"
#include "raytracing/study/chart_runs.h"
#include "raytracing/study/chart_summary.h"
#include "result_folder.h"
#include "scene_notes.h"
#include "signals.h"

namespace raytracing {
namespace {

ChartSettings chart_settings(const ChartArguments& a, const SceneFile& file,
                             const std::string& command_line) {
  ChartSettings s;
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
  return s;
}

/// A chart on its way.
class Chart {
 public:
  Chart(const ChartArguments& arguments, const ChartSettings& settings,
        const std::string& command_line, const StopOnSignal& signals)
      : a_(arguments),
        settings_(settings),
        command_line_(command_line),
        signals_(signals),
        folder_(arguments.folder, arguments.quiet) {}

  /// The exit code.
  int make(const Scene& scene) {
    const PixelMask mask = read_mask(a_.mask, settings_.width, settings_.height);
    if (!a_.mask.empty()) mask_id_ = fmt::format("{:016x}", hash_bytes(read_file(a_.mask)));
    if (a_.reference != "auto") {
      reference_ = read_reference(a_.reference, terms());
      if (!reference_->unchecked.empty())
        fmt::print(stderr, "warning: {}: its header does not tell {}: not checked\n",
                   one_line(a_.reference), reference_->unchecked);
    }
    folder_.create();
    claim_folder(a_.folder, settings_json(settings_, reference_id(), mask_id_));
    if (!reference_ && !take_auto_reference(scene))
      return stopped("before the reference was complete: the same command begins it anew");
    const PixelMask counted = counted_pixels(reference_->picture, mask);
    const auto floor = noise_floor(*reference_, counted);
    tell_reference(floor);

    RunLog log(a_.folder);
    if (log.dropped() > 0)
      fmt::print(stderr,
                 "warning: {} rows of {}/runs.csv have no picture in runs/ and are made "
                 "anew; the old table is kept as runs.csv.old\n",
                 log.dropped(), one_line(a_.folder));
    if (!make_all_runs(scene, {*reference_, counted, floor}, log))
      return stopped("finished runs are kept; the same command goes on");
    write_results(summarise_runs(settings_, log, *reference_, counted), log, counted);
    return kExitGood;
  }

 private:
  ReferenceTerms terms() const {
    ReferenceTerms terms{settings_.width,
                         settings_.height,
                         settings_.scene_hash,
                         depth_text(settings_.max_depth),
                         {}};
    for (const PlannedRun& run : plan_runs(settings_)) terms.seeds.push_back(run.seed);
    return terms;
  }

  // Of all that the reference depends on.
  std::string reference_id() const {
    if (a_.reference != "auto")
      return fmt::format("file of hash {:016x}", hash_bytes(read_file(a_.reference)));
    return fmt::format("auto, {}, {:g} s", reference_method(settings_.max_depth).name,
                       a_.reference_time);
  }

  // From the folder or rendered now. False when stopped.
  bool take_auto_reference(const Scene& scene) {
    const std::string id = settings_json(settings_, reference_id(), "").dump();
    const std::string path = fmt::format("{}/reference_{:016x}.exr", a_.folder, hash_bytes(id));
    if (std::filesystem::exists(path)) {
      reference_ = read_reference(path, terms());
      return true;
    }
    tell(fmt::format("rendering the reference by {} for {:g} s",
                     reference_method(settings_.max_depth).name, a_.reference_time));
    OutputFile file(path);
    ProgressDisplay display(a_.quiet ? ProgressStyle::none : a_.progress);
    auto picture = render_reference(
        scene, settings_, a_.reference_time, signals_.stop(),
        [&](std::uint64_t done, std::uint64_t total) { display.update(done, total); });
    display.finish(picture.has_value());
    if (!picture) return false;
    file.write(encode_image(*picture, ImageFormat::exr));
    file.commit();
    reference_ = to_reference(std::move(*picture));
    return true;
  }

  void tell_reference(const std::optional<NoiseFloor>& floor) const {
    if (floor)
      tell(fmt::format("reference: its own relMSE is {:.3g} ± {:.1g} ({}); subtracted",
                       floor->relmse.value, floor->relmse.standard_error,
                       reference_->variance_source));
    else
      fmt::print(stderr,
                 "warning: the reference's own noise is {}; it is not subtracted, and "
                 "there is no estimate of bias\n",
                 reference_->variance_source);
  }

  bool make_all_runs(const Scene& scene, const Yardstick& yardstick, RunLog& log) const {
    const std::vector<PlannedRun> runs = plan_runs(settings_);
    const auto finished = std::count_if(runs.begin(), runs.end(), [&](const PlannedRun& run) {
      return log.find(run.method->name, run.spp, run.repetition) != nullptr;
    });
    tell(fmt::format(
        "{}x{} pixels{}, {} methods, {} spp, {} seeds: {} runs, {} of them finished "
        "before",
        settings_.width, settings_.height, a_.width || a_.height ? "" : " (the scene's)",
        settings_.methods.size(), settings_.spp.size(), settings_.seeds, runs.size(), finished));
    ProgressDisplay display(a_.quiet ? ProgressStyle::none : a_.progress);
    const bool complete =
        make_runs(scene, settings_, runs, yardstick, log, signals_.stop(),
                  [&](std::uint64_t done, std::uint64_t total) { display.update(done, total); });
    display.finish(complete);
    return complete;
  }

  void write_results(const ChartSummary& summary, const RunLog& log,
                     const PixelMask& counted) const {
    tell_bias(summary);
    folder_.print_path("runs.csv");
    nlohmann::ordered_json json = settings_json(settings_, reference_id(), mask_id_);
    json.update(to_json(summary));
    folder_.write("summary.json", json.dump(2) + "\n");
    folder_.write("chart.dat", plot_data(summary, plot_bottom(summary)));
    folder_.write("chart.gp", plot_script(summary, chart_title(settings_)));
    const auto write_report = [&](bool has_charts) {
      folder_.write("report.html", report_html(chart_report(settings_, summary, log, *reference_,
                                                            counted, has_charts, facts())));
    };
    try {
      write_report(draw());
    } catch (const OutputError&) {  // the charts' failure shall not cost the tables
      write_report(false);
      throw;
    }
  }

  bool draw() const {
    if (!run_gnuplot(a_.folder, "chart.gp")) {
      fmt::print(stderr,
                 "no charts drawn: gnuplot is missing (Debian: gnuplot-nox); with it, the "
                 "same command draws them\n");
      return false;
    }
    for (const char* name :
         {"error_vs_time.svg", "error_vs_time.png", "error_vs_spp.svg", "error_vs_spp.png"})
      folder_.print_path(name);
    return true;
  }

  std::vector<std::pair<std::string, std::string>> facts() const {
    return {{"command", command_line_},     {"version", program_version()},
            {"build", build_description()}, {"machine", machine_description()},
            {"reference", reference_id()},  {"mask", mask_id_}};
  }

  void tell_bias(const ChartSummary& summary) const {
    for (const MethodSummary& m : summary.methods)
      if (m.bias()) tell(fmt::format("{}: {}", m.method->name, to_text(*m.bias())));
  }

  int stopped(const char* what_now) const {
    fmt::print(stderr, "stopped: {}\n", what_now);
    return kExitSignalBase + signals_.signal();
  }

  void tell(const std::string& line) const {
    if (!a_.quiet) fmt::print(stderr, "{}\n", line);
  }

  const ChartArguments& a_;
  const ChartSettings& settings_;
  const std::string& command_line_;
  const StopOnSignal& signals_;
  const ResultFolder folder_;
  std::optional<Reference> reference_;
  std::string mask_id_ = "none";
};

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
  const ChartSettings settings = chart_settings(a, file, arguments.command_line);
  const StopOnSignal signals;
  const auto asks_segments = [](const DirectMethod* m) { return m->asks_segments; };
  const bool segments = asks_segments(&reference_method(a.max_depth)) ||
                        std::any_of(a.methods.begin(), a.methods.end(), asks_segments);
  bring_near(file.scene);
  warn_of_narrow_pixels(file.scene.camera, settings.height);
  const Scene scene(std::move(file.scene), a.threads, segments);
  print_scene_notes(scene, a.quiet, false);
  return Chart(a, settings, arguments.command_line, signals).make(scene);
}

}  // namespace raytracing
