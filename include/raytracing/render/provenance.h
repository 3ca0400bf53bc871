#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace raytracing {

struct RenderOptions;
struct RenderResult;

/// A value as picture headers hold it.
using FactValue = std::variant<std::string, std::int64_t, double, bool>;
using NamedValues = std::vector<std::pair<std::string, FactValue>>;

/// Returns the value as text: all digits of a number, "true" or "false".
inline std::string to_text(const FactValue& value) {
  return std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
}

/// The facts of a run: what was rendered, how, by what, how long it took and what went wrong. A
/// fact that is not known is empty. fact_fields() lists the facts with their meanings.
struct RunFacts {
  std::optional<std::string> scene, scene_hash;
  std::optional<std::uint64_t> width, height;

  std::optional<std::string> light_sampling;
  std::optional<bool> light_sampling_biased;
  std::optional<std::uint64_t> line_rays;
  std::optional<FactValue> max_depth;  ///< a number or "unlimited"
  std::optional<std::string> sampler;
  std::optional<std::uint64_t> spp, replicates, reuse, seed;
  std::optional<std::string> seeds;

  std::optional<std::string> command, software, build, program, machine;
  std::optional<std::uint64_t> threads;

  std::optional<double> load_seconds, build_seconds, render_seconds, cpu_seconds;
  std::optional<std::uint64_t> peak_rss_bytes, paths;
  std::optional<double> paths_per_second;
  std::optional<std::uint64_t> rays_closest, rays_shadow, segment_queries, shaft_queries;

  std::optional<double> mean_r, mean_g, mean_b;
  std::optional<std::string> variance_kind, pixel_correlation;

  std::optional<bool> complete;
  std::optional<std::uint64_t> rays_escaped, area_fallbacks, non_finite_samples;
  std::optional<std::uint64_t> non_finite_geometry, non_finite_bsdf, non_finite_emission,
      non_finite_direct_light, non_finite_sum;
};

/// What a fact is about. Files that hold several runs keep facts by their scope.
enum class FactScope {
  setup,   ///< the picture asked for and the machine: the same for all runs of a chart
  run,     ///< the single run: a column of a chart's table of runs
  remark,  ///< of interest to people only, or derived from other facts
};

/// One entry of the list of facts. Its name is the same in every file.
struct FactField {
  using Member =
      std::variant<std::optional<std::string> RunFacts::*, std::optional<std::uint64_t> RunFacts::*,
                   std::optional<double> RunFacts::*, std::optional<bool> RunFacts::*,
                   std::optional<FactValue> RunFacts::*>;

  std::string_view name;
  std::string_view meaning;
  FactScope scope;
  Member member;
};

/// Returns all facts that files record. To add a fact, add a member to RunFacts, a row to this
/// list, and the statement that sets it; every header, table and JSON file then has it.
std::span<const FactField> fact_fields();

/// Returns the fact as a value; empty when it is not known. A whole number beyond 63 bits becomes
/// text.
std::optional<FactValue> fact_value(const RunFacts& facts, const FactField& field);

/// Sets the fact to what the text says; leaves it empty when the text is not of the fact's type.
void read_fact(RunFacts& facts, const FactField& field, std::string_view text);

/// Returns the known facts in the order of the list, for a picture's header.
NamedValues named_values(const RunFacts& facts);
/// Returns the facts that a picture's header states; other names are left out.
RunFacts facts_of(const NamedValues& header);

/// Returns the known facts as a JSON object, in the order of the list; only those of one scope if
/// it is given.
nlohmann::ordered_json to_json(const RunFacts& facts, std::optional<FactScope> scope = {});
/// Returns the facts that a JSON object states; other keys are left out.
RunFacts facts_from_json(const nlohmann::ordered_json& object);

/// Sets the facts that the options of a rendering determine.
void add_options(RunFacts& facts, const RenderOptions& options);
/// Sets the facts that are known when a rendering ends.
void add_result(RunFacts& facts, const RenderOptions& options, const RenderResult& result);

/// Returns RunFacts::max_depth as text: "1" or "unlimited".
std::string depth_text(const std::optional<std::uint32_t>& max_depth);
/// Returns a hash as headers show it: 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

/// Returns whether the facts say that the errors of neighbouring pixels are correlated: means over
/// pixels then vary more than the variances of single pixels suggest.
bool has_correlated_pixels(const RunFacts& facts);

}  // namespace raytracing
