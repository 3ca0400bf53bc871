#pragma once
// Makes a mesh of the records of an OBJ file and repairs its faces.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "raytracing/geometry/polygon_mesh.h"
#include "tally.h"
#include "text_cursor.h"

namespace raytracing {

class ObjMeshBuilder {
 public:
  /// Repaired and dropped faces and normals are counted in `tally`, which must outlive this.
  explicit ObjMeshBuilder(Tally& tally) : tally_(tally) {}

  /// Allocates each array at about the size that this OBJ text will fill.
  void reserve_for(std::string_view text);

  void add_position(const Vec3& position) { mesh_.positions.push_back(position); }
  void add_normal(Vec3 normal, const TextPlace& where);
  /// Adds a corner to the face that end_face() will close. Indices may be too high for now.
  void add_corner(const PolygonMesh::Corner& corner) { mesh_.corners.push_back(corner); }
  /// Closes a face, and drops it when it has no area.
  void end_face(std::uint32_t material, const TextPlace& where);

  std::size_t corner_count() const { return mesh_.corners.size(); }

  /// The mesh, once all records are added. All indices must be valid by now.
  PolygonMesh finish();

 private:
  // A face that was stated before its vertices, to be looked at when they are known.
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
  Tally& tally_;
  std::size_t first_corner_ = 0;  // of the face under construction
  std::vector<LateFace> late_faces_;
  std::vector<Vec3> outline_;  // scratch of has_area()
  bool has_zero_normals_ = false;
};

}  // namespace raytracing
