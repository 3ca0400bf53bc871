#include "raytracing/render/layers.h"

#include <limits>

namespace raytracing {
namespace {

using layer_content::OfFilm, layer_content::OfHits, layer_content::OfSamples;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Of a single sample or replicate no finite value would be honest.
DVec3 variance_of(const Film::Pixel& pixel) {
  return pixel.replicates < 2 ? DVec3(kInfinity) : pixel.variance_of_mean();
}

// To add a layer, add a row: its name, the letters of its channels, its meaning, and how the value
// of a pixel is found.
constexpr Layer kLayers[] = {
    {"albedo", "RGB",
     "reflectance of the first surface for denoisers, 0 to 1: that of a diffuse surface, that of a "
     "metal at normal incidence, 1 for a light that shines on the viewer, 0 where the ray leaves "
     "the scene",
     OfSamples{[](const LayerSample& s) {
       return s.first_hit ? DVec3(s.first_hit->albedo) : DVec3(0.0);
     }}},
    {"normal", "XYZ",
     "shading normal of the first surface on the side of the viewer, in the axes of the scene, -1 "
     "to 1; a mean, shorter than 1 at edges; 0 where the ray leaves the scene",
     OfSamples{[](const LayerSample& s) {
       return s.first_hit ? DVec3(s.first_hit->normal) : DVec3(0.0);
     }}},
    {"depth", "Z",
     "distance from the camera to the first surface, along the ray, in units of the scene; the "
     "mean of the rays that meet one; infinite where none does",
     OfHits{[](const FirstHit& hit) { return DVec3(hit.distance); }, kInfinity}},
    {"position", "XYZ",
     "point of the first surface in the coordinates of the scene file; the mean of the rays that "
     "meet one; 0 where none does",
     OfHits{[](const FirstHit& hit) { return hit.position; }, 0}},
    {"direct", "RGB",
     "light that comes from lights to the camera directly or by the first surface only",
     OfSamples{[](const LayerSample& s) { return DVec3(s.direct); }}},
    {"indirect", "RGB", "the rest of the light: direct + indirect is the picture",
     OfSamples{[](const LayerSample& s) { return DVec3(s.radiance) - DVec3(s.direct); }}},
    {"variance", "RGB",
     "estimated variance of the pixel mean, infinite where it is unknown. Without --replicates, it "
     "takes the samples of a pixel for independent, which is right with --sampler independent and "
     "too large with sobol",
     OfFilm{variance_of}},
    {"samples", "", "number of samples that the pixel is the mean of",
     OfFilm{[](const Film::Pixel& pixel) {
       return DVec3(static_cast<double>(pixel.samples_in_mean()));
     }}},
};

}  // namespace

std::vector<std::string> Layer::channels() const {
  std::vector<std::string> result;
  for (const char letter : letters) result.push_back(std::string(name) + '.' + letter);
  if (result.empty()) result.emplace_back(name);
  return result;
}

std::span<const Layer> layers() { return kLayers; }

const Layer* find_layer(std::string_view name) {
  for (const Layer& layer : kLayers)
    if (layer.name == name) return &layer;
  return nullptr;
}

std::vector<std::string> layer_names() {
  std::vector<std::string> names;
  for (const Layer& layer : kLayers) names.emplace_back(layer.name);
  return names;
}

}  // namespace raytracing
