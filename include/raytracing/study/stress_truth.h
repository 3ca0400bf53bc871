#pragma once

#include "raytracing/study/exact_polygons.h"
#include "raytracing/study/stress_case.h"

namespace raytracing {

/// The exact radiance of a stress scene at one vertex.
struct StressTruth {
  double radiance;
  /// How much it changes at most when shadow rays begin where the renderer's do, a few float
  /// spacings off the surface, and when the occluders move by four roundings of their own
  /// coordinates: what rays in float32 leave open.
  double rounding;
  /// The probability that a point uniform in the area of a light is seen, with the light chosen as
  /// the renderer does: a tenth evenly, the rest by power.
  double visible_share;
};

/// Red radiance that the vertex reflects to the viewer, directly from the lights. Diffuse surfaces:
/// Lambert's polygon formula on what it sees of each light. GGX: adaptive cubature over the same
/// polygons of a reflectance evaluated here in double. Of the renderer's vertex it takes position,
/// normals and material, nothing else. Light from below either horizon, of the geometric or the
/// shading normal, is lost, as in the renderer.
StressTruth exact_radiance(const StressScene& scene, const Vertex& vertex);

/// Radiance reflected by a GGX conductor of reflectance 1 from convex polygons of radiance 1, by
/// cubature to a relative 1e-7: at the point p with the unit normal n, towards the unit vector
/// `wo`.
double ggx_radiance(std::span<const LPolygon> pieces, const LVec3& p, const DVec3& n,
                    const DVec3& wo, double alpha);

}  // namespace raytracing
