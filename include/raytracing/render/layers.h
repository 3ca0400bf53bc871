#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "raytracing/integrator/first_hit.h"
#include "raytracing/render/film.h"

namespace raytracing {

/// One sample of a pixel, as layers see it.
struct LayerSample {
  Rgb radiance;  ///< as the picture counts it
  Rgb direct;    ///< the part of it that PathSample::direct is
  const std::optional<FirstHit>& first_hit;
};

/// What a pixel of a layer is. A layer of one channel is the x of these values.
namespace layer_content {
/// The mean over all samples.
struct OfSamples {
  DVec3 (*value)(const LayerSample& sample);
};
/// The mean over the samples whose ray met a surface; `otherwise` where none did.
struct OfHits {
  DVec3 (*value)(const FirstHit& hit);
  double otherwise;
};
/// A function of what the film holds anyway.
struct OfFilm {
  DVec3 (*value)(const Film::Pixel& pixel);
};
}  // namespace layer_content
using LayerContent =
    std::variant<layer_content::OfSamples, layer_content::OfHits, layer_content::OfFilm>;

/// One row of the table of layers: channels that a picture can have beside R, G and B.
struct Layer {
  std::string_view name;
  /// The letters of its channels: "XY" stands for name.X and name.Y, "" for the one channel `name`.
  std::string_view letters;
  std::string_view meaning;  ///< one line for people, without a full stop
  LayerContent content;

  std::vector<std::string> channels() const;
};

/// The table of layers, in the order in which they are listed to people.
std::span<const Layer> layers();

/// The layer of that name, or null.
const Layer* find_layer(std::string_view name);

std::vector<std::string> layer_names();

}  // namespace raytracing
