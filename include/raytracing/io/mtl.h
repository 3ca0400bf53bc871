#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/io/errors.h"
#include "raytracing/math/vec.h"
#include "raytracing/scene/description.h"

namespace raytracing {

/// A material of an MTL file, as written. Absent keys stay empty.
struct MtlMaterial {
  std::string name;
  TextLocation where;  ///< location of its newmtl record
  std::optional<Rgb> Kd, Ks, Ke;
  std::optional<float> Ns, Ni, d, Pr, Pm;
  std::optional<int> illum;
};

/// Parses MTL text; `file` is used in messages only. `Tr` is read as 1 - d. Keys without a meaning
/// here, such as textures, are counted as ignored. Throws InputError (file:line:column).
std::vector<MtlMaterial> parse_mtl(std::string_view text, const std::string& file,
                                   LoadReport& report);

/// Returns the surface that a material describes: Ke is the emitted radiance; Pm = 1 makes a GGX
/// conductor with constant reflectance Kd and roughness Pr, otherwise the surface is diffuse with
/// Kd. Counts in `report` what is absent or has no meaning here. Throws InputError (at newmtl) for
/// values out of range, and for a Pm between 0 and 1.
Surface surface_from_mtl(const MtlMaterial& mtl, LoadReport& report);

}  // namespace raytracing
