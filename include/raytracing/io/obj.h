#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/io/load_report.h"

namespace raytracing {

/// The contents of one OBJ file. Face::material indexes `materials`.
struct ObjModel {
  struct Library {
    std::string name;  ///< as written after mtllib; may hold spaces
    TextLocation where;
  };
  struct MaterialUse {
    std::string name;    ///< "" for faces before any usemtl
    TextLocation where;  ///< of the first usemtl of that name
  };

  PolygonMesh mesh;
  std::vector<MaterialUse> materials;  ///< one per distinct name, in order of first use
  std::vector<Library> libraries;      ///< every mtllib name, in order
};

/// Parses OBJ text. `file` is used in messages only. Reads v, vn, f, usemtl and mtllib; counts the
/// rest in `report`. Throws InputError (file:line:column) for what cannot be read.
ObjModel parse_obj(std::string_view text, const std::string& file, LoadReport& report);

/// Reads and parses a file. Throws InputError when it cannot be read.
ObjModel load_obj(const std::string& path, LoadReport& report);

}  // namespace raytracing
