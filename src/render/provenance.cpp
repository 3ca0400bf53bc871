#include "raytracing/render/provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "group_tracer.h"
#include "raytracing/render/pixel_groups.h"
#include "raytracing/render/render.h"

namespace raytracing {
namespace {

// A fact has the name of its member.
#define FACT(name, scope, meaning) \
  { #name, meaning, FactScope::scope, &RunFacts::name }

// clang-format off
constexpr FactField kFields[] = {
    FACT(scene, remark, "path of the scene file"),
    FACT(scene_hash, setup, "hash of the scene file and its models"),
    FACT(width, setup, "pixels in a row"),
    FACT(height, setup, "rows of pixels"),

    FACT(light_sampling, run, "method of direct light"),
    FACT(light_sampling_biased, run, "whether that method is biased"),
    FACT(line_rays, setup, "shadow rays per chord of the methods that trace several"),
    FACT(max_depth, setup, "largest number of surfaces on a path, or unlimited"),
    FACT(sampler, setup, "source of the random numbers"),
    FACT(spp, run, "samples per pixel"),
    FACT(replicates, setup, "independent groups of each pixel's samples"),
    FACT(reuse, setup, "edge of the groups of pixels that share paths; 1 if none do"),
    FACT(seed, run, "seed of the random numbers"),
    FACT(seeds, remark, "seeds of an image that was joined from several renderings"),

    FACT(command, remark, "command line"),
    FACT(software, setup, "name and version of the program"),
    FACT(build, setup, "build type, compiler and instruction set"),
    FACT(program, setup, "hash of the program's file"),
    FACT(machine, setup, "processor and the number of its threads"),
    FACT(threads, setup, "threads that rendered"),

    FACT(load_seconds, remark, "time to read the scene"),
    FACT(build_seconds, remark, "time to build the acceleration structures"),
    FACT(render_seconds, run, "wall-clock time of rendering"),
    FACT(cpu_seconds, run, "processor time of rendering, of all threads"),
    FACT(peak_rss_bytes, remark, "largest resident memory of the process"),
    FACT(paths, run, "camera paths traced"),
    FACT(paths_per_second, remark, "camera paths per second of wall-clock time"),
    FACT(rays_closest, run, "closest-hit ray queries"),
    FACT(rays_shadow, run, "shadow ray queries"),
    FACT(segment_queries, run, "queries for the unoccluded parts of a segment"),
    FACT(shaft_queries, run, "shaft queries that found which of many points see one"),

    FACT(mean_r, run, "mean of the red channel over all pixels"),
    FACT(mean_g, run, "mean of the green channel over all pixels"),
    FACT(mean_b, run, "mean of the blue channel over all pixels"),
    FACT(variance_kind, remark, "how the variance layers were estimated"),
    FACT(pixel_correlation, remark, "whether errors of neighbouring pixels are correlated"),

    FACT(complete, remark, "false if the rendering was stopped early"),
    FACT(rays_escaped, run, "closest-hit rays from a surface that met nothing"),
    FACT(area_fallbacks, run,
         "light samples drawn by area since their solid angle is too small or too large"),
    FACT(non_finite_samples, run, "samples that were not finite and count as black"),
    FACT(non_finite_geometry, run, "non-finite samples due to a position or normal"),
    FACT(non_finite_bsdf, run, "non-finite samples due to the throughput"),
    FACT(non_finite_emission, run, "non-finite samples due to emission that the path met"),
    FACT(non_finite_direct_light, run, "non-finite samples due to an estimate of direct light"),
    FACT(non_finite_sum, run, "non-finite samples due to a sum of finite terms"),
};
// clang-format on
#undef FACT

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
      PixelGroups::tile_edge(group_edge(options)));
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
  facts.reuse = group_edge(options);
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
