#pragma once
// Builds a mesh from the records of an OBJ file and repairs its faces.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/io/load_report.h"

namespace raytracing {

class ObjMeshBuilder {
 public:
  /// Counts repaired and dropped faces and normals in `report`. Both arguments must outlive this.
  ObjMeshBuilder(const std::string& file, LoadReport& report) : file_(file), report_(report) {}

  /// Allocates each array at about the size that it will have after this OBJ text.
  void reserve_for(std::string_view text);

  void add_position(const Vec3& position) { mesh_.positions.push_back(position); }
  void add_normal(Vec3 normal, const TextPlace& where);
  /// Adds a corner to the face that end_face() will close. Its indices may belong to later records.
  void add_corner(const PolygonMesh::Corner& corner) { mesh_.corners.push_back(corner); }
  /// Closes a face, and drops it when it has no area.
  void end_face(std::uint32_t material, const TextPlace& where);

  std::size_t corner_count() const { return mesh_.corners.size(); }

  /// Returns the mesh once all records are added. All indices must be valid by now.
  PolygonMesh finish();

 private:
  // A face that precedes its vertices; its area is checked once they are known.
  struct LateFace {
    std::uint32_t face;
    TextPlace where;
  };

  void add_face(std::uint32_t material);
  bool is_plain_triangle() const;
  bool remove_repeated_corners();
  bool is_late() const;
  bool has_area(std::size_t first, std::size_t count);
  void drop_late_faces();
  void forget_zero_normals();

  PolygonMesh mesh_;
  const std::string& file_;
  LoadReport& report_;
  std::size_t first_corner_ = 0;  // of the face under construction
  std::vector<LateFace> late_faces_;
  std::vector<Vec3> outline_;  // scratch memory of has_area()
  bool has_zero_normals_ = false;
};

}  // namespace raytracing
