#pragma once

#include <string>

#include "raytracing/io/image.h"
#include "raytracing/render/film.h"
#include "raytracing/render/provenance.h"

namespace raytracing {

/// The picture with the facts of its run as header. With `variance`, the layers variance.R/G/B hold
/// the variance of the pixel means.
ImageData to_image(const Film& film, RunFacts facts, bool variance);

/// The contents of the file that --stats writes: one JSON object.
std::string stats_json(const RunFacts& facts);

}  // namespace raytracing
