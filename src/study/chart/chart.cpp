#include "raytracing/study/chart/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/study/chart/plot.h"
#include "raytracing/study/chart/report.h"
#include "raytracing/study/chart/runs.h"
#include "raytracing/study/chart/summary.h"
#include "raytracing/study/page/result_folder.h"

namespace raytracing {
namespace {

/// The steps of make_chart() and what they share.
class Chart {
 public:
  Chart(const ChartRequest& request, const std::atomic<bool>& stop, ChartListener& listener)
      : request_(request), settings_(request.settings), stop_(stop), listener_(listener) {}

  ChartEnd make(const Scene& scene) {
    const PixelMask mask = read_chart_mask();
    if (!request_.mask.empty()) mask_id_ = hash_of_file(request_.mask);
    std::optional<Reference> reference;
    reference_id_ = reference_id();
    if (!is_automatic()) reference = read_reference_file();
    const ResultFolder folder(settings_.folder,
                              [this](const std::string& name) { listener_.file_written(name); });
    claim_folder(settings_.folder, settings_json(settings_, reference_id_, mask_id_));
    if (is_automatic()) reference = automatic_reference(scene);
    if (!reference) return ChartEnd::stopped_in_reference;
    const GroundTruth truth(std::move(*reference), mask);
    describe(truth);

    RunLog log(settings_.folder);
    for (const std::string& line : log.warnings()) listener_.warn(line);
    if (!make_all_runs(scene, truth, log)) return ChartEnd::stopped_in_runs;
    write_results(folder, summarise_runs(settings_, log, truth), log, truth);
    return ChartEnd::complete;
  }

 private:
  bool is_automatic() const { return request_.reference == "auto"; }

  static std::string hash_of_file(const std::string& path) {
    return hash_text(hash_bytes(read_file(path)));
  }

  ReferenceTerms terms() const {
    ReferenceTerms terms{settings_.width,
                         settings_.height,
                         settings_.scene_hash,
                         depth_text(settings_.max_depth),
                         {}};
    for (const PlannedRun& run : plan_runs(settings_)) terms.seeds.push_back(run.seed);
    return terms;
  }

  PixelMask read_chart_mask() const {
    std::vector<std::string> notes;
    PixelMask mask = read_mask(request_.mask, settings_.width, settings_.height,
                               {0, 0, settings_.width, settings_.height}, notes);
    for (const std::string& note : notes) listener_.note(note);
    return mask;
  }

  // Names everything that the reference depends on.
  std::string reference_id() const {
    if (!is_automatic()) return "file of hash " + hash_of_file(request_.reference);
    return fmt::format("auto, {}, {:g} s", reference_method(settings_.max_depth).name,
                       request_.reference_seconds);
  }

  Reference read_reference_file() const {
    Reference reference = read_reference(request_.reference, terms());
    for (const std::string& note : reference.picture.notes)
      listener_.note(fmt::format("note: {}: {}", request_.reference, note));
    if (!reference.unchecked.empty())
      listener_.warn(fmt::format("{}: not checked, since its header lacks them: {}",
                                 request_.reference, reference.unchecked));
    return reference;
  }

  // Takes the reference from the folder, or renders it. Empty when stopped.
  std::optional<Reference> automatic_reference(const Scene& scene) const {
    const std::string id = settings_json(settings_, reference_id_, "").dump();
    const std::string path =
        fmt::format("{}/reference_{}.exr", settings_.folder, hash_text(hash_bytes(id)));
    if (std::filesystem::exists(path)) return read_reference(path, terms());
    listener_.note(fmt::format("rendering the reference by {} for {:g} s",
                               reference_method(settings_.max_depth).name,
                               request_.reference_seconds));
    OutputFile file(path);
    listener_.progress_began();
    auto picture =
        render_reference(scene, settings_, request_.reference_seconds, stop_, progress());
    listener_.progress_ended(picture.has_value());
    if (!picture) return std::nullopt;
    file.write(encode_image(*picture, "exr"));
    file.commit();
    return to_reference(std::move(*picture));
  }

  void describe(const GroundTruth& truth) const {
    const std::string& source = truth.reference.variance_source;
    if (const auto count = truth.reference.non_finite_samples; count.value_or(0) > 0)
      listener_.warn(
          fmt::format("{} samples of the reference were not finite and count as black", *count));
    if (truth.floor)
      listener_.note(fmt::format("reference: its own relMSE is {:.3g} ± {:.1g} ({}); subtracted",
                                 truth.floor->relmse.value, truth.floor->relmse.standard_error,
                                 source));
    else
      listener_.warn(
          fmt::format("the reference's own noise is {}; it is not subtracted, and there is no "
                      "estimate of bias",
                      source));
  }

  bool make_all_runs(const Scene& scene, const GroundTruth& truth, RunLog& log) const {
    const std::vector<PlannedRun> runs = plan_runs(settings_);
    const auto finished = std::count_if(runs.begin(), runs.end(), [&](const PlannedRun& run) {
      return log.find(run.method->name, run.spp, run.repetition) != nullptr;
    });
    listener_.note(fmt::format(
        "{}x{} pixels, {} methods, {} spp, {} seeds: {} runs, {} of them finished before",
        settings_.width, settings_.height, settings_.methods.size(), settings_.spp.size(),
        settings_.seeds, runs.size(), finished));
    listener_.progress_began();
    const bool complete = make_runs(scene, settings_, truth, log, stop_, progress());
    listener_.progress_ended(complete);
    return complete;
  }

  ProgressCallback progress() const {
    return [this](std::uint64_t done, std::uint64_t total) { listener_.progress(done, total); };
  }

  void write_results(const ResultFolder& folder, const ChartSummary& summary, const RunLog& log,
                     const GroundTruth& truth) const {
    for (const MethodSummary& m : summary.methods)
      if (m.bias()) listener_.note(fmt::format("{}: {}", m.method->name, to_text(*m.bias())));
    listener_.file_written("runs.csv");
    nlohmann::ordered_json json = settings_json(settings_, reference_id_, mask_id_);
    if (const auto count = truth.reference.non_finite_samples)
      json["reference_non_finite_samples"] = *count;
    json.update(to_json(summary));
    folder.write("summary.json", json.dump(2) + "\n");
    folder.write("chart.dat", plot_data(summary, plot_bottom(summary)));
    folder.write("chart.gp", plot_script(summary, chart_title(settings_)));
    const auto write_report = [&](bool has_charts) {
      folder.write("report.html",
                   report_html(chart_report(settings_, summary, log, truth, has_charts, facts())));
    };
    try {
      write_report(draw(folder));
    } catch (const OutputError&) {  // a failure of gnuplot must not cost the tables
      write_report(false);
      throw;
    }
  }

  bool draw(const ResultFolder& folder) const {
    if (folder.draw("chart.gp", picture_files({"error_vs_time", "error_vs_spp"}))) return true;
    listener_.warn(
        "no charts drawn: gnuplot is missing (Debian: gnuplot-nox); with it, the same command "
        "draws them");
    return false;
  }

  std::vector<std::pair<std::string, std::string>> facts() const {
    auto facts = fact_rows(common_facts(settings_));
    facts.emplace_back("reference", reference_id_);
    facts.emplace_back("mask", mask_id_);
    return facts;
  }

  const ChartRequest& request_;
  const ChartSettings& settings_;
  const std::atomic<bool>& stop_;
  ChartListener& listener_;
  std::string reference_id_, mask_id_ = "none";
};

}  // namespace

ChartEnd make_chart(const Scene& scene, const ChartRequest& request, const std::atomic<bool>& stop,
                    ChartListener& listener) {
  return Chart(request, stop, listener).make(scene);
}

}  // namespace raytracing
