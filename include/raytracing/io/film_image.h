#pragma once

#include "raytracing/io/image.h"
#include "raytracing/render/film.h"
#include "raytracing/render/layer_film.h"
#include "raytracing/render/provenance.h"

namespace raytracing {

/// The pixel means of a film and the channels of its layers, with the facts of its run as metadata.
ImageData to_image(const Film& film, RunFacts facts, const LayerFilm& layers = {});

}  // namespace raytracing
