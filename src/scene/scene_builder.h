#pragma once

#include <span>
#include <vector>

#include "raytracing/scene/scene.h"

namespace raytracing {

/// The parts of a Scene while they are made from its description.
struct Scene::Builder {
  explicit Builder(SceneDescription description);

  std::vector<Material> materials;
  std::vector<std::uint32_t> sphere_materials;
  std::vector<TriangleRecord> records;
  std::vector<SmoothNormals> smooth_normals;
  std::vector<AreaLight> lights;
  CameraDescription camera;
  BuildNotes notes;
  std::vector<Vec3> positions;
  std::vector<EmbreeScene::Triangle> triangles;
  std::vector<Sphere> spheres;

 private:
  void add_mesh(const PolygonMesh& mesh, std::span<const Surface> surfaces);
  void add_face(const PolygonMesh& mesh, const PolygonMesh::Face& face, std::uint32_t base,
                const Surface& surface);
  std::uint32_t add_light(std::span<const Vec3> corners, const Rgb& Le);
  std::uint32_t add_normals(const PolygonMesh& mesh, const PolygonMesh::Corner* const corners[3],
                            const Vec3& ng);

  std::vector<Vec3> face_positions_;  // scratch of add_face
};

}  // namespace raytracing
