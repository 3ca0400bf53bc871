// Real runs of the Cornell box: the bias of line-ratio is found, none of the other methods is
// accused, and half a per cent that is planted is found, in direct light and in all bounces.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "raytracing/io/file.h"
#include "raytracing/io/image.h"
#include "raytracing/io/scene_file.h"
#include "raytracing/study/chart/report.h"
#include "raytracing/study/chart/runs.h"
#include "raytracing/study/chart/summary.h"
#include "support/temp_dir.h"

namespace raytracing {
namespace {

const std::atomic<bool> kNever{false};

class ChartBias : public ::testing::Test {
 protected:
  explicit ChartBias(int size = 64, std::optional<std::uint32_t> max_depth = 1) {
    LoadReport report;
    SceneFile file = load_scene_file(std::string(RAYTRACING_SOURCE_DIR) + "/scenes/cornell.toml",
                                     direct_method_names(), report);
    scene_.emplace(std::move(file.scene), 2);
    settings_.folder = folder_.path();
    settings_.width = settings_.height = size;
    settings_.max_depth = max_depth;
    settings_.threads = 2;
    settings_.spp = {64};
    for (const char* name : {"point", "line-ratio", "line"})
      settings_.methods.push_back(&direct_method(name));
    // As many samples on any machine, so not by render_reference().
    truth_.emplace(to_reference(join_halves(half(0), half(1))), PixelMask());
    log_.emplace(folder_.path());
    EXPECT_TRUE(make_runs(*scene_, settings_, *truth_, *log_, kNever, nullptr));
  }

  ImageData half(std::uint64_t i) const {
    const PlannedRun run{&direct_method("line"), 512, 0, kFirstReferenceSeed + i};
    const RenderResult result = render(*scene_, run_options(settings_, run), kNever, nullptr);
    ImageData image{settings_.width, settings_.height, {"R", "G", "B"}, {}, {}};
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        for (int c = 0; c < 3; ++c)
          image.values.push_back(static_cast<float>(result.film.at(x, y).mean()[c]));
    return image;
  }

  bool detected(std::size_t method) const {
    const ChartSummary summary = summarise_runs(settings_, *log_, *truth_);
    return summary.methods[method].bias()->detected;
  }

  void brighten(const char* method, float factor) {
    for (std::uint64_t i = 0; i < settings_.seeds; ++i) {
      const std::string path = log_->picture_path(method, 64, i);
      ImageData image = read_image(path);
      for (float& value : image.values) value *= factor;
      image.metadata.clear();
      write_file(path, encode_image(image, "exr"));
    }
  }

  TempDir folder_;
  std::optional<Scene> scene_;
  ChartSettings settings_;
  std::optional<GroundTruth> truth_;
  std::optional<RunLog> log_;
};

TEST_F(ChartBias, IsFoundWhereThereIsOneAndNowhereElse) {
  EXPECT_FALSE(detected(0));
  EXPECT_TRUE(detected(1));
  EXPECT_FALSE(detected(2));
  brighten("point", 1.005f);
  brighten("line", 0.995f);
  EXPECT_TRUE(detected(0));
  EXPECT_TRUE(detected(2));
}

class ChartBiasOfAllBounces : public ChartBias {
 protected:
  ChartBiasOfAllBounces() : ChartBias(64, ChartSettings{}.max_depth) {}
};

TEST_F(ChartBiasOfAllBounces, IsFoundWhereItIsPlanted) {
  EXPECT_FALSE(detected(0));
  EXPECT_FALSE(detected(2));
  brighten("point", 1.005f);
  brighten("line", 0.995f);
  EXPECT_TRUE(detected(0));
  EXPECT_TRUE(detected(2));
}

class ChartRuns : public ChartBias {
 protected:
  ChartRuns() : ChartBias(16) {}
};

TEST_F(ChartRuns, AreMeasuredAsTheirPicturesAre) {
  const auto floor = truth_->floor;
  ASSERT_EQ(log_->runs().size(), 3 * settings_.seeds);
  for (const ChartRun& run : log_->runs()) {
    const ImageData image =
        read_image(log_->picture_path(*run.facts.light_sampling, 64, run.repetition));
    const ErrorMetrics metrics = error_metrics(image, truth_->reference.picture);
    EXPECT_EQ(run.relmse, metrics.relmse);
    EXPECT_EQ(run.mse, metrics.mse);
    EXPECT_EQ(run.smape, metrics.smape);
    EXPECT_EQ(run.relmse_corrected, metrics.relmse - floor->relmse.value);
    EXPECT_EQ(run.largest, *std::max_element(image.values.begin(), image.values.end()));
    EXPECT_EQ(run.facts.spp, 64u);
    EXPECT_EQ(run.facts.rays_closest, 16u * 16u * 64u);
    EXPECT_GT(run.facts.render_seconds, 0);
    EXPECT_EQ(run.facts.seed, run_seed(64, run.repetition));
    const RunFacts header = facts_of(image.metadata);
    EXPECT_EQ(header.seed, run.facts.seed);
    EXPECT_EQ(header.light_sampling_biased, run.facts.light_sampling == "line-ratio");
  }
}

TEST_F(ChartRuns, AReferenceRenderedInNoTimeHasTwoChunks) {
  const auto picture = render_reference(*scene_, settings_, 0, kNever, nullptr);
  ASSERT_TRUE(picture);
  const RunFacts header = facts_of(picture->metadata);
  EXPECT_EQ(header.spp, 32u);
  EXPECT_EQ(header.light_sampling, "line");
  write_file(folder_ / "rendered.exr", encode_image(*picture, "exr"));
  ReferenceTerms terms{16, 16, settings_.scene_hash, depth_text(settings_.max_depth), {}};
  for (const PlannedRun& run : plan_runs(settings_)) terms.seeds.push_back(run.seed);
  const Reference read = read_reference(folder_ / "rendered.exr", terms);
  EXPECT_EQ(read.unchecked, "");
  EXPECT_EQ(read.variance_source, "from two independent halves");
  // Its own estimate of its error, against the reference of 1024 samples.
  const double error = error_metrics(read.picture, truth_->reference.picture).relmse;
  const Estimate floor = noise_floor(read, truth_->counted)->relmse;
  EXPECT_GT(floor.value, 0);
  EXPECT_LT(error, 3 * floor.value);
  EXPECT_GT(error, floor.value / 3);
}

TEST_F(ChartRuns, AStoppedReferenceIsNone) {
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(render_reference(*scene_, settings_, 0, stop, nullptr));
}

TEST_F(ChartRuns, AreReportedWithTheirNumbers) {
  brighten("line", 1.05f);
  const ChartSummary summary = summarise_runs(settings_, *log_, *truth_);
  const Report report = chart_report(settings_, summary, *log_, *truth_, false, {{"command", "c"}});
  ASSERT_EQ(report.pictures.size(), 4u);
  EXPECT_EQ(report.pictures[1].label, "line-ratio (biased)");
  EXPECT_EQ(report.pictures[3].label, "reference");
  EXPECT_TRUE(report.pictures[3].error_png.empty());
  EXPECT_TRUE(report.charts.empty());
  ASSERT_EQ(report.tables.size(), 5u);
  for (const ReportTable& table : report.tables)
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.header.size()) << table.caption;
  const auto& points = report.tables[4].rows;  // one for each method at its only spp
  ASSERT_EQ(points.size(), 3u);
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_EQ(points[m][0], settings_.methods[m]->name);
    EXPECT_EQ(points[m][1], "64");
    const Spread& relmse = summary.methods[m].points[0].relmse;
    EXPECT_EQ(points[m][3],
              fmt::format("{:.3g} ({:.3g} to {:.3g})", relmse.median, relmse.low, relmse.high));
  }
  const auto& fits = report.tables[2].rows;
  EXPECT_EQ(fits[0].back(), "no");
  EXPECT_EQ(fits[2].back(), "yes");
  EXPECT_EQ(fits[0][1], "-");  // no slope through one point
}

TEST_F(ChartRuns, AreNotRepeated) {
  const std::string before = read_file(folder_ / "runs.csv");
  std::uint64_t told = 0;
  const auto count = [&told](std::uint64_t, std::uint64_t) { ++told; };
  settings_.seeds = 4;
  EXPECT_TRUE(make_runs(*scene_, settings_, *truth_, *log_, kNever, count));
  EXPECT_EQ(told, 0u);
  EXPECT_EQ(read_file(folder_ / "runs.csv"), before);
  settings_.seeds = 9;
  EXPECT_TRUE(make_runs(*scene_, settings_, *truth_, *log_, kNever, count));
  EXPECT_EQ(log_->runs().size(), 27u);
  EXPECT_TRUE(read_file(folder_ / "runs.csv").starts_with(before));
}

}  // namespace
}  // namespace raytracing
