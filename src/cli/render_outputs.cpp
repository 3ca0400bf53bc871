#include "render_outputs.h"

#include <limits>
#include <nlohmann/json.hpp>

namespace raytracing {
namespace {

// A single sample or replicate tells nothing of its variance; no finite value would be honest.
DVec3 variance_layer(const Film::Pixel& pixel) {
  if (pixel.replicates < 2) return DVec3(std::numeric_limits<double>::infinity());
  return pixel.variance_of_mean();
}

}  // namespace

ImageData to_image(const Film& film, RunFacts facts, bool variance) {
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
  if (!variance) {  // there are no layers that these facts could describe
    facts.variance_kind.reset();
    facts.pixel_correlation.reset();
  }
  image.metadata = named_values(facts);
  return image;
}

std::string stats_json(const RunFacts& facts) { return to_json(facts).dump(2) + "\n"; }

}  // namespace raytracing
