// Every fact of the list survives every kind of file that holds it.

#include "raytracing/render/provenance.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "raytracing/io/image.h"
#include "raytracing/render/render.h"
#include "raytracing/study/chart/runs.h"

namespace raytracing {
namespace {

// All facts, with different values that need all digits of their types.
RunFacts full_facts() {
  RunFacts facts;
  std::uint64_t number = UINT64_MAX;
  for (const FactField& field : fact_fields()) {
    --number;
    std::visit(
        [&](auto member) {
          using Value = typename std::decay_t<decltype(facts.*member)>::value_type;
          if constexpr (std::is_same_v<Value, std::string>)
            facts.*member = "text of " + std::string(field.name);
          else if constexpr (std::is_same_v<Value, bool>)
            facts.*member = number % 2 == 0;
          else if constexpr (std::is_same_v<Value, FactValue>)
            facts.*member = std::int64_t{12};
          else if constexpr (std::is_same_v<Value, double>)
            facts.*member = 1.0 / static_cast<double>(number % 1000 + 3);
          else
            facts.*member = number;
        },
        field.member);
  }
  return facts;
}

ImageData picture(const RunFacts& facts) {
  return {1, 1, {"R", "G", "B"}, {0, 0, 0}, named_values(facts)};
}

void expect_equal(const RunFacts& found, const RunFacts& wanted, bool of_runs_only = false) {
  for (const FactField& field : fact_fields()) {
    if (of_runs_only && field.scope != FactScope::run) continue;
    EXPECT_EQ(fact_value(found, field), fact_value(wanted, field)) << field.name;
    EXPECT_TRUE(fact_value(found, field)) << field.name;
  }
}

TEST(FactFields, HaveNamesOfTheirOwnInOneSpelling) {
  std::set<std::string_view> names;
  for (const FactField& field : fact_fields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_EQ(field.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos);
    EXPECT_FALSE(field.meaning.empty()) << field.name;
  }
}

// A member that no row of the list holds would be lost in every file.
TEST(FactFields, CoverEveryMember) {
  RunFacts facts = full_facts();
  std::size_t size = 0;
  for (const FactField& field : fact_fields())
    size += std::visit([&](auto member) { return sizeof(facts.*member); }, field.member);
  EXPECT_LT(sizeof(RunFacts) - size, sizeof(std::optional<double>));  // padding
}

TEST(FactFields, SurviveExr) {
  const std::string bytes = encode_image(picture(full_facts()), "exr");
  expect_equal(facts_of(decode_image(bytes, "x").metadata), full_facts());
}

TEST(FactFields, SurvivePng) {
  const std::string bytes = encode_image(picture(full_facts()), "png");
  expect_equal(facts_of(decode_image(bytes, "x").metadata), full_facts());
}

TEST(FactFields, SurviveJson) {
  const auto json = nlohmann::ordered_json::parse(to_json(full_facts()).dump());
  EXPECT_EQ(json.size(), fact_fields().size());
  expect_equal(facts_from_json(json), full_facts());
}

TEST(FactFields, OfSingleRunsSurviveTheTableOfRuns) {
  ChartRun run;
  run.facts = full_facts();
  const auto back = run_from_csv(to_csv(run));
  ASSERT_TRUE(back);
  expect_equal(back->facts, full_facts(), true);
}

TEST(FactFields, UnknownFactsAreAbsent) {
  EXPECT_TRUE(named_values({}).empty());
  EXPECT_TRUE(to_json(RunFacts{}).empty());
  const RunFacts facts = facts_of({{"spp", "many"}, {"seed", 1.5}, {"light_sampling_biased", "?"}});
  EXPECT_TRUE(named_values(facts).empty());
}

TEST(RunFacts, UnlimitedDepthIsAWord) {
  RunFacts facts;
  facts.max_depth = "unlimited";
  EXPECT_EQ(facts_from_json(to_json(facts)).max_depth, FactValue("unlimited"));
  EXPECT_EQ(facts_of(named_values(facts)).max_depth, FactValue("unlimited"));
  EXPECT_EQ(depth_text(std::nullopt), "unlimited");
  EXPECT_EQ(depth_text(3), "3");
}

// A rendering sets all facts except those that the command line and the loader add.
TEST(RunFacts, ReuseIsThatOfTheRendering) {
  RenderOptions options;
  options.path.method = &direct_methods().front();
  RunFacts facts;
  for (const int edge : {1, 4, 16}) {
    options.reuse = edge;
    options.path.max_depth.reset();
    add_options(facts, options);
    EXPECT_EQ(facts.reuse, edge);
    options.path.max_depth = 1;  // paths end where they would be shared
    add_options(facts, options);
    EXPECT_EQ(facts.reuse, 1);
  }
}

TEST(RunFacts, OfARenderingAreAllThere) {
  RenderOptions options;
  options.width = options.height = 1;
  options.path.method = &direct_methods()[0];
  RunFacts facts;
  add_options(facts, options);
  add_result(facts, options, RenderResult(Film(1, 1)));
  const std::set<std::string_view> added_elsewhere{
      "scene",   "scene_hash", "seeds",        "command",       "software",      "build",
      "program", "machine",    "load_seconds", "build_seconds", "peak_rss_bytes"};
  for (const FactField& field : fact_fields())
    EXPECT_NE(fact_value(facts, field).has_value(), added_elsewhere.count(field.name) > 0)
        << field.name;
}

}  // namespace
}  // namespace raytracing
