#pragma once

#include <variant>

#include "raytracing/math/vec.h"

namespace raytracing {

/// Lambert's reflector: f = reflectance / pi on both sides.
struct Diffuse {
  Rgb reflectance{0.5f};  ///< each in [0,1]
};

/// How the reflectance of a conductor depends on the angle between half vector and direction.
enum class Fresnel {
  none,     ///< constant: the reflectance at every angle
  schlick,  ///< Schlick 1994, eq. 15, with the reflectance at normal incidence
};

/// Rough conductor with the GGX distribution of microfacets (Walter et al. 2007), height-correlated
/// Smith masking and shadowing (Heitz 2014, eq. 99), single scattering.
struct GgxConductor {
  Rgb reflectance{0.9f};  ///< each in [0,1]
  float alpha = 0.16f;    ///< roughness squared, in (0,1]
  Fresnel fresnel = Fresnel::none;
};

/// The closed set of surface reflectances.
using Material = std::variant<Diffuse, GgxConductor>;

}  // namespace raytracing
