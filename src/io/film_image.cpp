#include "raytracing/io/film_image.h"

#include <utility>

namespace raytracing {

ImageData to_image(const Film& film, RunFacts facts, const LayerFilm& layers) {
  ImageData image;
  image.width = film.width();
  image.height = film.height();
  image.channels = {"R", "G", "B"};
  for (std::string& channel : layers.channels()) image.channels.push_back(std::move(channel));
  image.values.reserve(image.channels.size() * film.width() * film.height());
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      const Film::Pixel& pixel = film.at(x, y);
      const DVec3 mean = pixel.mean();
      for (const double c : {mean.x, mean.y, mean.z}) image.values.push_back(static_cast<float>(c));
      layers.append_values(x, y, pixel, image.values);
    }
  if (!layers.has("variance")) {  // these facts would describe layers that are not there
    facts.variance_kind.reset();
    facts.pixel_correlation.reset();
  }
  image.metadata = named_values(facts);
  return image;
}

}  // namespace raytracing
