// The plan of a chart's runs, and folders that belong to another chart.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "raytracing/io/errors.h"
#include "raytracing/study/chart/settings.h"
#include "support/temp_dir.h"

namespace raytracing {
namespace {

ChartSettings example() {
  ChartSettings settings;
  for (const DirectMethod& method : direct_methods()) settings.methods.push_back(&method);
  settings.width = settings.height = 8;
  settings.spp = {1, 2, 4};
  settings.seeds = 2 * direct_methods().size();
  settings.made_by.build = "x";
  settings.made_by.command = "y";
  return settings;
}

TEST(ChartPlan, HoldsEveryRunOnce) {
  std::set<std::tuple<std::string_view, std::uint64_t, std::uint64_t>> runs;
  const auto plan = plan_runs(example());
  for (const PlannedRun& run : plan) {
    runs.insert({run.method->name, run.spp, run.repetition});
    EXPECT_EQ(run.seed, run_seed(run.spp, run.repetition));
    EXPECT_LT(run.seed, kFirstReferenceSeed);
  }
  EXPECT_EQ(plan.size(), 3 * example().seeds * direct_methods().size());
  EXPECT_EQ(runs.size(), plan.size());
}

TEST(ChartPlan, NoTwoPointsShareASeed) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t spp : {1, 2, 3, 64, 65, 1 << 20, 1 << 30})
    for (std::uint64_t repetition : {0, 1, 7, 8, (1 << 20) - 1})
      EXPECT_TRUE(seeds.insert(run_seed(spp, repetition)).second);
}

// Each method comes first, second ... equally often, so that no place in the turn favours it.
TEST(ChartPlan, MethodsAlternate) {
  const auto plan = plan_runs(example());
  const std::size_t count = direct_methods().size();
  std::map<std::pair<std::string_view, std::size_t>, int> places;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    ++places[{plan[i].method->name, i % count}];
    EXPECT_EQ(plan[i].spp, plan[i / count * count].spp);
    EXPECT_EQ(plan[i].repetition, plan[i / count * count].repetition);
  }
  const auto [least, most] =
      std::minmax_element(places.begin(), places.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; });
  EXPECT_EQ(places.size(), count * count);
  EXPECT_EQ(least->second, most->second);
}

class ClaimedFolder : public ::testing::Test {
 protected:
  std::string refusal(const ChartSettings& settings, const std::string& reference = "auto") {
    try {
      claim_folder(folder_.path(), settings_json(settings, reference, "none"));
      return "";
    } catch (const InputError& error) {
      const std::string path = folder_ / "settings.json";
      EXPECT_TRUE(std::string(error.what()).starts_with(path));
      return std::string(error.what()).substr(path.size());
    }
  }
  TempDir folder_;
};

TEST_F(ClaimedFolder, TakesTheSameSettingsAgain) {
  EXPECT_EQ(refusal(example()), "");
  EXPECT_EQ(refusal(example()), "");
}

TEST_F(ClaimedFolder, TakesOtherMethodsSppSeedsAndCommandLines) {
  EXPECT_EQ(refusal(example()), "");
  ChartSettings other = example();
  other.methods.pop_back();
  other.spp = {8};
  other.seeds = 3;
  other.made_by.command = "z";
  EXPECT_EQ(refusal(other), "");
}

TEST_F(ClaimedFolder, RefusesWhatDiffers) {
  EXPECT_EQ(refusal(example()), "");
  ChartSettings other = example();
  other.max_depth = 1;
  EXPECT_EQ(refusal(other),
            ": made with max_depth \"unlimited\", not 1; choose another --out, "
            "or remove this one");
  for (const auto& change : std::vector<void (*)(ChartSettings&)>{
           [](ChartSettings& s) { s.scene_hash = 1; }, [](ChartSettings& s) { s.width = 9; },
           [](ChartSettings& s) { s.height = 9; }, [](ChartSettings& s) { s.line_rays = 9; },
           [](ChartSettings& s) { s.threads = 9; },
           [](ChartSettings& s) { s.sampler = SamplerKind::independent; },
           [](ChartSettings& s) { s.made_by.build = "another"; }}) {
    other = example();
    change(other);
    EXPECT_NE(refusal(other), "");
  }
  EXPECT_NE(refusal(example(), "file of hash 1"), "");
}

TEST_F(ClaimedFolder, RefusesWhatIsNoJson) {
  folder_.write("settings.json", "{");
  EXPECT_EQ(refusal(example()), ": not a JSON object");
}

}  // namespace
}  // namespace raytracing
