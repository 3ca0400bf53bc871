#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/io/load_report.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// One newmtl record, as written. Absent keys stay empty.
struct MtlMaterial {
  std::string name;
  TextLocation where;  ///< of its newmtl line
  std::optional<Rgb> Kd, Ks, Ke;
  std::optional<float> Ns, Ni, d, Pr, Pm;
  std::optional<int> illum;
};

/// Parses MTL text. `Tr` is read as 1 - d. Keys that have no meaning here (textures and so on) are
/// named once each in `report` as ignored. Throws InputError (file:line:column).
std::vector<MtlMaterial> parse_mtl(std::string_view text, const std::string& file,
                                   LoadReport& report);

/// Reads and parses a file. Throws InputError when it cannot be read.
std::vector<MtlMaterial> load_mtl(const std::string& path, LoadReport& report);

}  // namespace raytracing
