#include "raytracing/render/layer_film.h"

#include <algorithm>

namespace raytracing {
namespace {

using layer_content::OfFilm, layer_content::OfHits, layer_content::OfSamples;

// The value that a sample adds to a layer, if any.
std::optional<DVec3> value_of(const LayerContent& content, const LayerSample& sample) {
  std::optional<DVec3> value;
  if (const auto* of_samples = std::get_if<OfSamples>(&content))
    value = of_samples->value(sample);
  else if (const auto* of_hits = std::get_if<OfHits>(&content); of_hits && sample.first_hit)
    value = of_hits->value(*sample.first_hit);
  return value && is_finite(*value) ? value : std::nullopt;
}

// What a pixel without any value shows.
DVec3 value_of_none(const LayerContent& content) {
  const auto* of_hits = std::get_if<OfHits>(&content);
  return DVec3(of_hits != nullptr ? of_hits->otherwise : 0.0);
}

}  // namespace

LayerFilm::LayerFilm(std::span<const Layer* const> layers, int width, int height) : width_(width) {
  for (const Layer* layer : layers) {
    planes_.push_back({layer, {}});
    if (std::holds_alternative<OfFilm>(layer->content)) continue;
    planes_.back().sums.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    sums_samples_ = true;
  }
}

void LayerFilm::add(int x, int y, const Film::Pixel& pixel, const LayerSample& sample) {
  const bool replicate_is_complete = pixel.samples == pixel.counted;
  for (Plane& plane : planes_) {
    if (plane.sums.empty()) continue;
    Sum& s = plane.sums[index(x, y)];
    if (const std::optional<DVec3> value = value_of(plane.layer->content, sample)) {
      s.open_sum += *value;
      ++s.open_count;
    }
    if (!replicate_is_complete) continue;
    s.sum += s.open_sum;
    s.count += s.open_count;
    s.open_sum = DVec3(0.0);
    s.open_count = 0;
  }
}

bool LayerFilm::has(std::string_view layer) const {
  return std::any_of(planes_.begin(), planes_.end(),
                     [layer](const Plane& plane) { return plane.layer->name == layer; });
}

std::vector<std::string> LayerFilm::channels() const {
  std::vector<std::string> result;
  for (const Plane& plane : planes_)
    for (std::string& channel : plane.layer->channels()) result.push_back(std::move(channel));
  return result;
}

void LayerFilm::append_values(int x, int y, const Film::Pixel& pixel,
                              std::vector<float>& values) const {
  const auto value_in = [&](const Plane& plane) {
    const LayerContent& content = plane.layer->content;
    if (const auto* of_film = std::get_if<OfFilm>(&content)) return of_film->value(pixel);
    const Sum& s = plane.sums[index(x, y)];
    const auto& [sum, count] =
        pixel.replicates > 0 ? std::pair(s.sum, s.count) : std::pair(s.open_sum, s.open_count);
    return count > 0 ? sum / static_cast<double>(count) : value_of_none(content);
  };
  for (const Plane& plane : planes_) {
    const DVec3 value = value_in(plane);
    const auto n = std::max<std::size_t>(plane.layer->letters.size(), 1);
    for (std::size_t i = 0; i < n; ++i)
      values.push_back(static_cast<float>(value[static_cast<DVec3::length_type>(i)]));
  }
}

}  // namespace raytracing
