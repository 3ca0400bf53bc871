#pragma once

#include "raytracing/scene/scene.h"

namespace raytracing {

/// What the ray of the camera meets, without the light there: of all samples of a pixel it differs
/// only by where they lie in the pixel.
struct FirstHit {
  DVec3 position;   ///< in the coordinates of the scene file
  Vec3 normal;      ///< shading normal on the side of the viewer, world, unit
  Rgb albedo;       ///< each in [0,1]; see describe_first_hit()
  double distance;  ///< from the origin of the ray, > 0
};

/// Describes the vertex `v` at which `ray` arrived. The albedo is the one that denoisers ask for
/// (Open Image Denoise): the reflectance of a diffuse surface, that of a metal at normal incidence,
/// and 1 where a light shines on the viewer, as if all its light were reflected.
FirstHit describe_first_hit(const Scene& scene, const Vertex& v, const Ray& ray);

}  // namespace raytracing
