#pragma once

#include <functional>

#include "raytracing/study/stress/cases.h"
#include "raytracing/study/stress/exact_polygons.h"

namespace raytracing {

/// Ray casters round the corners relative to the ray's origin and their products: the occluders of
/// the exact radiance are moved by so many roundings of their coordinates.
inline constexpr int kOccluderRoundings = 4;

/// The exact radiance of a stress scene at one vertex.
struct StressTruth {
  double radiance;
  /// The largest change of the radiance when shadow rays begin where the renderer's do, a few float
  /// spacings off the surface, and when the occluders move by kOccluderRoundings roundings of their
  /// own coordinates: the uncertainty of rays in float32.
  double rounding;
  /// The probability that a point uniform in the area of a light is seen, with the light chosen as
  /// the renderer does: a tenth evenly, the rest by power.
  double visible_share;
};

/// The red radiance of direct light that the vertex reflects to the viewer. For diffuse surfaces it
/// is Lambert's polygon formula on the visible part of each light, for GGX adaptive cubature over
/// the same polygons of a BRDF evaluated here in double. Only position, normals and material come
/// from the renderer's vertex. Light from below the horizon of the geometric or the shading normal
/// is lost, as in the renderer.
StressTruth exact_radiance(const StressScene& scene, const Vertex& vertex);

/// The red radiance reflected by the material from convex polygons of radiance 1, at the point p
/// with the unit normal n, towards the unit vector `wo`. The reflectance of a conductor is taken as
/// constant over the angle.
double reflected_radiance(const Material& material, std::span<const LPolygon> pieces,
                          const LVec3& p, const DVec3& n, const DVec3& wo);

/// The radiance reflected by a GGX conductor of reflectance 1 from convex polygons of radiance 1,
/// by cubature to a relative 1e-7: at the point p with the unit normal n, towards the unit vector
/// `wo`.
double ggx_radiance(std::span<const LPolygon> pieces, const LVec3& p, const DVec3& n,
                    const DVec3& wo, double alpha);

/// The integral of f(s, t) over the unit square by the Gauss-Legendre rule of 8 x 8 points in each
/// of panels x panels equal squares.
double integrate_square(const std::function<double(double, double)>& f, int panels);

}  // namespace raytracing
