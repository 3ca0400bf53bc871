#include "raytracing/render/film.h"

#include <algorithm>

namespace raytracing {

DVec3 Film::Pixel::mean() const {
  if (replicates > 0) return sum / static_cast<double>(counted);
  return samples == 0 ? open_sum : open_sum / static_cast<double>(samples);
}

DVec3 Film::Pixel::variance_of_mean() const {
  if (replicates < 2) return DVec3(0.0);
  const double n = static_cast<double>(replicates);
  const double replicate_size = static_cast<double>(counted) / n;
  const DVec3 centred = sum_of_squares - sum * sum / n;
  return glm::max(centred, DVec3(0.0)) / (n * (n - 1) * replicate_size * replicate_size);
}

std::uint64_t Film::fewest_replicates() const {
  std::uint64_t fewest = pixels_.front().replicates;
  for (const Pixel& pixel : pixels_) fewest = std::min(fewest, pixel.replicates);
  return fewest;
}

DVec3 Film::mean() const {
  DVec3 total(0.0);
  for (const Pixel& pixel : pixels_) total += pixel.mean();
  return total / static_cast<double>(pixels_.size());
}

}  // namespace raytracing
