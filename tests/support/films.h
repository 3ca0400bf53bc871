#pragma once
// Whole renders, and their films compared bit by bit.

#include "raytracing/render/render.h"

namespace raytracing {

inline RenderResult render_all(const Scene& scene, const RenderOptions& options) {
  return render(scene, options, false, {});
}

/// Whether two pixels have the same sums, in every bit, of the same samples.
inline bool same_pixel(const Film::Pixel& a, const Film::Pixel& b) {
  return a.sum == b.sum && a.sum_of_squares == b.sum_of_squares && a.samples == b.samples &&
         a.replicates == b.replicates;
}

/// Number of pixels that are not the same. The films must be of one size.
inline int differing_pixels(const Film& a, const Film& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += same_pixel(a.at(x, y), b.at(x, y)) ? 0 : 1;
  return count;
}

}  // namespace raytracing
