#include "render_outputs.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "build_info.h"
#include "raytracing/render/pixel_groups.h"

namespace raytracing {
namespace {

std::int64_t peak_rss_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{1024} * usage.ru_maxrss;
}

// Text where a header's 64 bits with a sign do not suffice.
ImageMetadata::value_type::second_type whole_number(std::uint64_t value) {
  if (value > static_cast<std::uint64_t>(INT64_MAX)) return std::to_string(value);
  return static_cast<std::int64_t>(value);
}

// How the layers variance.R/G/B were estimated, for people.
std::string variance_kind(const RenderRecord& r) {
  const std::uint64_t replicates = r.result.film.fewest_replicates();
  if (replicates < 2)
    return fmt::format("unknown: a pixel has fewer than two complete {}",
                       r.options.replicates > 1 ? "replicates" : "samples");
  if (r.options.replicates > 1)
    return fmt::format(
        "between the means of replicates: honest; Student's t with {} degrees of "
        "freedom",
        replicates - 1);
  return r.options.sampler == SamplerKind::independent
             ? "between independent samples: honest"
             : "between samples as if they were independent: too large for sobol";
}

// What the variances of single pixels do not tell, for people.
std::string correlation_kind(const RenderRecord& r) {
  if (!shares_paths(r.options)) return "none: the samples of different pixels are independent";
  return fmt::format(
      "errors of pixels less than {} apart are alike: means over regions vary more "
      "than the variances of their pixels say",
      PixelGroups::tile_edge(r.options.reuse));
}

// Of a single sample or replicate nothing is known: not even a wide interval is wide enough.
DVec3 variance_layer(const Film::Pixel& pixel) {
  if (pixel.replicates < 2) return DVec3(std::numeric_limits<double>::infinity());
  return pixel.variance_of_mean();
}

// "geometry 0, bsdf 2, ..." for a header.
std::string by_cause(const RenderResult& result) {
  std::string text;
  for (std::size_t i = 0; i < kNonFiniteCauses; ++i)
    text += fmt::format("{}{} {}", i > 0 ? ", " : "", to_string(static_cast<NonFiniteCause>(i)),
                        result.non_finite_by_cause[i]);
  return text;
}

ImageMetadata metadata(const RenderRecord& r) {
  const DirectMethod& method = *r.options.shade.method;
  const auto& depth = r.options.shade.max_depth;
  return {
      {"software", "Raytracing " + program_version()},
      {"build", build_description()},
      {"argv", r.command_line},
      {"scene", r.scene_path},
      {"sceneHash", fmt::format("{:016x}", r.scene.hash)},
      {"seed", whole_number(r.options.seed)},
      {"spp", static_cast<std::int64_t>(r.options.spp)},
      {"replicates", static_cast<std::int64_t>(r.options.replicates)},
      {"reuse", static_cast<std::int64_t>(r.options.reuse)},
      {"sampler", std::string(to_string(r.options.sampler))},
      {"lightSampling", std::string(method.name)},
      {"lightSamplingBiased", std::string(method.unbiased ? "no" : "yes")},
      {"maxDepth", depth ? std::to_string(*depth) : "unlimited"},
      {"threads", static_cast<std::int64_t>(r.result.threads)},
      {"renderSeconds", r.result.render_seconds},
      {"paths", whole_number(r.result.paths)},
      {"nonFiniteSamples", static_cast<std::int64_t>(r.result.non_finite_samples)},
      {"nonFiniteByCause", by_cause(r.result)},
      {"escapedRays", whole_number(r.result.rays.escaped)},
      {"areaFallbacks", whole_number(r.result.rays.area_fallbacks)},
      {"complete", std::string(r.result.complete ? "yes" : "no, stopped early")},
  };
}

}  // namespace

ImageData to_image(const RenderRecord& r, bool variance) {
  const Film& film = r.result.film;
  ImageData image;
  image.width = film.width();
  image.height = film.height();
  image.channels = {"R", "G", "B"};
  if (variance)
    image.channels.insert(image.channels.end(), {"variance.R", "variance.G", "variance.B"});
  image.values.reserve(image.channels.size() * film.width() * film.height());
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      const auto append = [&](const DVec3& v) {
        for (double c : {v.x, v.y, v.z}) image.values.push_back(static_cast<float>(c));
      };
      append(film.at(x, y).mean());
      if (variance) append(variance_layer(film.at(x, y)));
    }
  image.metadata = metadata(r);
  if (!variance) return image;
  image.metadata.emplace_back("varianceKind", variance_kind(r));
  image.metadata.emplace_back("pixelCorrelation", correlation_kind(r));
  return image;
}

std::string stats_json(const RenderRecord& r) {
  const DirectMethod& method = *r.options.shade.method;
  const DVec3 mean = r.result.film.mean();
  nlohmann::ordered_json j;
  j["scene"] = r.scene_path;
  j["light_sampling"] = method.name;
  j["light_sampling_biased"] = !method.unbiased;
  j["sampler"] = to_string(r.options.sampler);
  j["spp"] = r.options.spp;
  j["replicates"] = r.options.replicates;
  j["reuse"] = r.options.reuse;
  j["variance_kind"] = variance_kind(r);
  j["pixel_correlation"] = correlation_kind(r);
  j["width"] = r.options.width;
  j["height"] = r.options.height;
  j["max_depth"] = nullptr;
  if (r.options.shade.max_depth) j["max_depth"] = *r.options.shade.max_depth;
  j["seed"] = r.options.seed;
  j["threads"] = r.result.threads;
  j["load_seconds"] = r.load_seconds;
  j["build_seconds"] = r.build_seconds;
  j["render_seconds"] = r.result.render_seconds;
  j["cpu_seconds"] = r.result.cpu_seconds;
  j["paths"] = r.result.paths;
  j["paths_per_second"] = static_cast<double>(r.result.paths) / r.result.render_seconds;
  j["rays_closest"] = r.result.rays.closest;
  j["rays_shadow"] = r.result.rays.shadow;
  j["segment_queries"] = r.result.rays.segments;
  j["shaft_queries"] = r.result.rays.shafts;
  j["peak_rss_bytes"] = peak_rss_bytes();
  j["rays_escaped"] = r.result.rays.escaped;
  j["area_fallbacks"] = r.result.rays.area_fallbacks;
  j["non_finite_samples"] = r.result.non_finite_samples;
  for (std::size_t i = 0; i < kNonFiniteCauses; ++i)
    j["non_finite_by_cause"][to_string(static_cast<NonFiniteCause>(i))] =
        r.result.non_finite_by_cause[i];
  j["complete"] = r.result.complete;
  j["mean_rgb"] = {mean.x, mean.y, mean.z};
  return j.dump(2) + "\n";
}

}  // namespace raytracing
