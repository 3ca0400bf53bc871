#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/io/errors.h"

namespace raytracing {

/// The contents of an OBJ file. Face::material is an index into `materials`.
struct ObjModel {
  struct Library {
    std::string name;  ///< as written after mtllib; may hold spaces
    TextLocation where;
  };
  struct MaterialUse {
    std::string name;    ///< "" for faces before the first usemtl
    TextLocation where;  ///< of the first usemtl of that name
  };

  PolygonMesh mesh;
  std::vector<MaterialUse> materials;  ///< one per name, in order of first use
  std::vector<Library> libraries;      ///< every mtllib name, in order
};

/// Parses OBJ text; `file` is used in messages only. Reads v, vn, f, usemtl and mtllib, and counts
/// all other records, repaired and dropped faces in `report`. Throws InputError (file:line:column)
/// for malformed records.
ObjModel parse_obj(std::string_view text, const std::string& file, LoadReport& report);

}  // namespace raytracing
