#include "raytracing/render/provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "raytracing/render/pixel_groups.h"
#include "raytracing/render/render.h"

namespace raytracing {
namespace {

constexpr auto kSetup = FactScope::setup;
constexpr auto kRun = FactScope::run;
constexpr auto kRemark = FactScope::remark;

constexpr FactField kFields[] = {
    {"scene", "path of the scene file", kRemark, &RunFacts::scene},
    {"scene_hash", "hash of the scene file and its models", kSetup, &RunFacts::scene_hash},
    {"width", "pixels in a row", kSetup, &RunFacts::width},
    {"height", "rows of pixels", kSetup, &RunFacts::height},

    {"light_sampling", "method of direct light", kRun, &RunFacts::light_sampling},
    {"light_sampling_biased", "whether that method is biased", kRun,
     &RunFacts::light_sampling_biased},
    {"line_rays", "shadow rays per chord of the method line-rays", kSetup, &RunFacts::line_rays},
    {"max_depth", "largest number of surfaces on a path, or unlimited", kSetup,
     &RunFacts::max_depth},
    {"sampler", "source of the random numbers", kSetup, &RunFacts::sampler},
    {"spp", "samples per pixel", kRun, &RunFacts::spp},
    {"replicates", "independent groups of each pixel's samples", kSetup, &RunFacts::replicates},
    {"reuse", "edge of the groups of pixels that share paths; 1: none do", kSetup,
     &RunFacts::reuse},
    {"seed", "seed of the random numbers", kRun, &RunFacts::seed},
    {"seeds", "seeds of a picture that was joined from several renderings", kRemark,
     &RunFacts::seeds},

    {"command", "command line", kRemark, &RunFacts::command},
    {"software", "name and version of the program", kSetup, &RunFacts::software},
    {"build", "build type, compiler and instruction set", kSetup, &RunFacts::build},
    {"program", "hash of the program's file", kSetup, &RunFacts::program},
    {"machine", "processor", kSetup, &RunFacts::machine},
    {"threads", "threads that rendered", kSetup, &RunFacts::threads},

    {"load_seconds", "time to read the scene", kRemark, &RunFacts::load_seconds},
    {"build_seconds", "time to build the acceleration structures", kRemark,
     &RunFacts::build_seconds},
    {"render_seconds", "wall-clock time of rendering", kRun, &RunFacts::render_seconds},
    {"cpu_seconds", "processor time of rendering, of all threads", kRun, &RunFacts::cpu_seconds},
    {"peak_rss_bytes", "largest resident memory of the process", kRemark,
     &RunFacts::peak_rss_bytes},
    {"paths", "camera paths traced", kRun, &RunFacts::paths},
    {"paths_per_second", "camera paths per second of wall-clock time", kRemark,
     &RunFacts::paths_per_second},
    {"rays_closest", "closest-hit ray queries", kRun, &RunFacts::rays_closest},
    {"rays_shadow", "shadow ray queries", kRun, &RunFacts::rays_shadow},
    {"segment_queries", "queries for the unoccluded parts of a segment", kRun,
     &RunFacts::segment_queries},
    {"shaft_queries", "queries for the occluders of a shaft", kRun, &RunFacts::shaft_queries},

    {"mean_r", "mean of the red channel over all pixels", kRun, &RunFacts::mean_r},
    {"mean_g", "mean of the green channel over all pixels", kRun, &RunFacts::mean_g},
    {"mean_b", "mean of the blue channel over all pixels", kRun, &RunFacts::mean_b},
    {"variance_kind", "how the variance layers were estimated", kRemark, &RunFacts::variance_kind},
    {"pixel_correlation", "whether errors of neighbouring pixels are correlated", kRemark,
     &RunFacts::pixel_correlation},

    {"complete", "false when the rendering was stopped early", kRemark, &RunFacts::complete},
    {"rays_escaped", "closest-hit rays from a surface that met nothing", kRun,
     &RunFacts::rays_escaped},
    {"area_fallbacks", "lights sampled by area, their solid angle being too small", kRun,
     &RunFacts::area_fallbacks},
    {"non_finite_samples", "samples that were not finite and count as black", kRun,
     &RunFacts::non_finite_samples},
    {"non_finite_geometry", "non-finite samples due to a position or normal", kRun,
     &RunFacts::non_finite_geometry},
    {"non_finite_bsdf", "non-finite samples due to the throughput", kRun,
     &RunFacts::non_finite_bsdf},
    {"non_finite_emission", "non-finite samples due to emission that the path met", kRun,
     &RunFacts::non_finite_emission},
    {"non_finite_direct_light", "non-finite samples due to an estimate of direct light", kRun,
     &RunFacts::non_finite_direct_light},
    {"non_finite_sum", "non-finite samples due to a sum of finite terms", kRun,
     &RunFacts::non_finite_sum},
};

// Describes how the layers variance.R/G/B were estimated.
std::string variance_kind(const RenderOptions& options, const RenderResult& result) {
  const std::uint64_t replicates = result.film.fewest_replicates();
  if (replicates < 2)
    return fmt::format("unknown: a pixel has fewer than two complete {}",
                       options.replicates > 1 ? "replicates" : "samples");
  if (options.replicates > 1)
    return fmt::format(
        "between the means of replicates: honest; Student's t with {} degrees of freedom",
        replicates - 1);
  return options.sampler == SamplerKind::independent
             ? "between independent samples: honest"
             : "between samples as if they were independent: too large for sobol";
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (stop != end || error != std::errc()) return std::nullopt;
  return number;
}

FactValue depth_fact(const std::optional<std::uint32_t>& max_depth) {
  if (!max_depth) return "unlimited";
  return std::int64_t{*max_depth};
}

constexpr std::string_view kUncorrelated = "none";

std::string pixel_correlation(const RenderOptions& options) {
  if (!shares_paths(options))
    return fmt::format("{}: the samples of different pixels are independent", kUncorrelated);
  return fmt::format(
      "errors of pixels less than {} apart are correlated: means over regions vary more than the "
      "variances of their pixels say",
      PixelGroups::tile_edge(options.reuse));
}

}  // namespace

std::span<const FactField> fact_fields() { return kFields; }

std::optional<FactValue> fact_value(const RunFacts& facts, const FactField& field) {
  return std::visit(
      [&facts](auto member) -> std::optional<FactValue> {
        const auto& fact = facts.*member;
        if (!fact) return std::nullopt;
        if constexpr (std::is_same_v<decltype(*fact), const std::uint64_t&>) {
          if (*fact > static_cast<std::uint64_t>(INT64_MAX)) return std::to_string(*fact);
          return static_cast<std::int64_t>(*fact);
        } else {
          return *fact;
        }
      },
      field.member);
}

void read_fact(RunFacts& facts, const FactField& field, std::string_view text) {
  std::visit(
      [&](auto member) {
        auto& fact = facts.*member;
        using Value = typename std::decay_t<decltype(fact)>::value_type;
        fact.reset();
        if constexpr (std::is_same_v<Value, std::string>) {
          fact = text;
        } else if constexpr (std::is_same_v<Value, bool>) {
          if (text == "true" || text == "false") fact = text == "true";
        } else if constexpr (std::is_same_v<Value, FactValue>) {
          if (const auto number = number_in<std::int64_t>(text))
            fact = *number;
          else
            fact = std::string(text);
        } else {
          fact = number_in<Value>(text);
        }
      },
      field.member);
}

NamedValues named_values(const RunFacts& facts) {
  NamedValues values;
  for (const FactField& field : kFields)
    if (const auto value = fact_value(facts, field))
      values.emplace_back(std::string(field.name), *value);
  return values;
}

RunFacts facts_of(const NamedValues& header) {
  RunFacts facts;
  for (const auto& entry : header)
    for (const FactField& field : kFields)
      if (field.name == entry.first) read_fact(facts, field, to_text(entry.second));
  return facts;
}

nlohmann::ordered_json to_json(const RunFacts& facts, std::optional<FactScope> scope) {
  nlohmann::ordered_json object;
  for (const FactField& field : kFields) {
    if (scope && field.scope != *scope) continue;
    const auto add_value = [&](const auto& value) { object[std::string(field.name)] = value; };
    const auto add_member = [&](auto member) {
      const auto& fact = facts.*member;
      if (!fact) return;
      if constexpr (std::is_same_v<decltype(*fact), const FactValue&>)
        std::visit(add_value, *fact);
      else
        add_value(*fact);
    };
    std::visit(add_member, field.member);
  }
  return object;
}

RunFacts facts_from_json(const nlohmann::ordered_json& object) {
  RunFacts facts;
  for (const FactField& field : kFields) {
    const auto found = object.find(field.name);
    if (found == object.end()) continue;
    read_fact(facts, field, found->is_string() ? found->get<std::string>() : found->dump());
  }
  return facts;
}

void add_options(RunFacts& facts, const RenderOptions& options) {
  const DirectMethod& method = *options.path.method;
  facts.width = options.width;
  facts.height = options.height;
  facts.light_sampling = method.name;
  facts.light_sampling_biased = !method.unbiased;
  facts.line_rays = options.path.line_rays;
  facts.max_depth = depth_fact(options.path.max_depth);
  facts.sampler = to_string(options.sampler);
  facts.spp = options.spp;
  facts.replicates = options.replicates;
  facts.reuse = options.reuse;
  facts.seed = options.seed;
  facts.threads = options.threads;
}

void add_result(RunFacts& facts, const RenderOptions& options, const RenderResult& result) {
  facts.threads = result.threads;
  facts.render_seconds = result.render_seconds;
  facts.cpu_seconds = result.cpu_seconds;
  facts.paths = result.paths;
  facts.paths_per_second = static_cast<double>(result.paths) / result.render_seconds;
  facts.rays_closest = result.rays.closest;
  facts.rays_shadow = result.rays.shadow;
  facts.segment_queries = result.rays.segments;
  facts.shaft_queries = result.rays.shafts;
  const DVec3 mean = result.film.mean();
  facts.mean_r = mean.x;
  facts.mean_g = mean.y;
  facts.mean_b = mean.z;
  facts.variance_kind = variance_kind(options, result);
  facts.pixel_correlation = pixel_correlation(options);
  facts.complete = result.complete;
  facts.rays_escaped = result.rays.escaped;
  facts.area_fallbacks = result.rays.area_fallbacks;
  facts.non_finite_samples = result.non_finite_samples;
  const auto by = [&result](NonFiniteCause cause) {
    return result.non_finite_by_cause[static_cast<std::size_t>(cause)];
  };
  facts.non_finite_geometry = by(NonFiniteCause::geometry);
  facts.non_finite_bsdf = by(NonFiniteCause::bsdf);
  facts.non_finite_emission = by(NonFiniteCause::emission);
  facts.non_finite_direct_light = by(NonFiniteCause::direct_light);
  facts.non_finite_sum = by(NonFiniteCause::sum);
}

std::string depth_text(const std::optional<std::uint32_t>& max_depth) {
  return to_text(depth_fact(max_depth));
}

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

bool has_correlated_pixels(const RunFacts& facts) {
  return facts.pixel_correlation && !facts.pixel_correlation->starts_with(kUncorrelated);
}

}  // namespace raytracing
