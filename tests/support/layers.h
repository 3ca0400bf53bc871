#pragma once
// Pictures with layers, whose channels are found by name.

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "raytracing/io/film_image.h"
#include "raytracing/io/image.h"
#include "support/films.h"

namespace raytracing {

/// All layers of the table.
inline std::vector<const Layer*> all_layers() {
  std::vector<const Layer*> result;
  for (const Layer& layer : layers()) result.push_back(&layer);
  return result;
}

/// A picture that the program would write.
struct LayeredPicture {
  explicit LayeredPicture(ImageData data) : image(std::move(data)) {}
  explicit LayeredPicture(const RenderResult& result)
      : image(to_image(result.film, {}, result.layers)) {}

  float at(int x, int y, std::string_view channel) const {
    const auto& names = image.channels;
    const auto found = std::find(names.begin(), names.end(), channel);
    if (found == names.end()) throw std::runtime_error("no channel " + std::string(channel));
    return image.values.at((static_cast<std::size_t>(y) * image.width + x) * names.size() +
                           static_cast<std::size_t>(found - names.begin()));
  }
  /// The channels layer.R, layer.G and layer.B, or those of other letters.
  DVec3 at3(int x, int y, const std::string& layer, const char* letters = "RGB") const {
    return {at(x, y, layer + '.' + letters[0]), at(x, y, layer + '.' + letters[1]),
            at(x, y, layer + '.' + letters[2])};
  }
  DVec3 radiance(int x, int y) const { return {at(x, y, "R"), at(x, y, "G"), at(x, y, "B")}; }

  ImageData image;
};

/// The picture with all layers.
inline LayeredPicture render_layers(const Scene& scene, RenderOptions options) {
  options.layers = all_layers();
  return LayeredPicture(render_all(scene, options));
}

}  // namespace raytracing
