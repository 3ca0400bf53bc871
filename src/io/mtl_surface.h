#pragma once

#include "raytracing/io/load_report.h"
#include "raytracing/io/mtl.h"
#include "raytracing/scene/description.h"

namespace raytracing {

/// What an MTL record means here: Ke is the radiance; Pm = 1 makes a GGX conductor of constant
/// reflectance Kd and roughness Pr, else the surface is diffuse with Kd. Counts in `report` what
/// is absent or has no meaning. Throws InputError (at newmtl) for values out of range, and for a Pm
/// between 0 and 1.
Surface surface_from_mtl(const MtlMaterial& mtl, LoadReport& report);

}  // namespace raytracing
