#include "raytracing/render/film.h"

namespace raytracing {

DVec3 Film::Pixel::variance_of_mean() const {
  if (samples < 2) return DVec3(0.0);
  const double n = static_cast<double>(samples);
  const DVec3 centred = sum_of_squares - sum * sum / n;
  return glm::max(centred, DVec3(0.0)) / (n * (n - 1));
}

DVec3 Film::mean() const {
  DVec3 total(0.0);
  for (const Pixel& pixel : pixels_) total += pixel.mean();
  return total / static_cast<double>(pixels_.size());
}

}  // namespace raytracing
