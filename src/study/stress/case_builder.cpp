#include "case_builder.h"

#include <fmt/format.h>

#include "raytracing/geometry/polygon_mesh.h"

namespace raytracing::stress {

StressScene scene_of(const Setup& setup) { return CaseBuilder(setup).scene; }

CaseBuilder::CaseBuilder(const Setup& setup) {
  const std::uint32_t surface = add_surface(setup.material);
  const Vec3 x(setup.half, 0.0f, 0.0f), y(0.0f, setup.half, 0.0f);
  add_faces({parallelogram(Vec3(0.0f), x, y)}, surface);
  scene.ray = {kPoint + setup.eye * setup.wo, -setup.wo};
  for (const Polygon& light : setup.lights) add_light(light);
  for (const Polygon& occluder : setup.occluders) add_occluder(occluder);
}

std::uint32_t CaseBuilder::add_surface(const Material& material, float Le) {
  scene.scene.surfaces.push_back({"", material, Rgb(Le)});
  return static_cast<std::uint32_t>(scene.scene.surfaces.size() - 1);
}

void CaseBuilder::add_faces(const std::vector<Polygon>& faces, std::uint32_t surface) {
  PolygonMesh mesh;
  for (const Polygon& face : faces) {
    mesh.faces.push_back({static_cast<std::uint32_t>(mesh.corners.size()),
                          static_cast<std::uint32_t>(face.size()), surface});
    for (const Vec3& corner : face) {
      mesh.corners.push_back({static_cast<std::uint32_t>(mesh.positions.size())});
      mesh.positions.push_back(corner);
    }
  }
  scene.scene.meshes.push_back(std::move(mesh));
}

void CaseBuilder::add_light(Polygon corners, float Le) {
  if (dot(newell_normal(corners), DVec3(kPoint) - DVec3(corners[0])) < 0)
    corners = {corners.rbegin(), corners.rend()};
  add_faces({corners}, add_surface(Diffuse{Rgb(0.0f)}, Le));
  scene.lights.push_back({std::move(corners), Le});
}

void CaseBuilder::add_occluder(const Polygon& corners) { add_occluder({corners}, corners); }

void CaseBuilder::add_occluder(const std::vector<Polygon>& faces, const Polygon& silhouette) {
  add_black_faces(faces);
  scene.occluders.push_back(silhouette);
}

void CaseBuilder::add_black_faces(const std::vector<Polygon>& faces) {
  if (!black_) black_ = add_surface(Diffuse{Rgb(0.0f)});
  add_faces(faces, *black_);
}

Polygon ceiling_light() { return parallelogram(kCenter, {0.5f, 0.0f, 0.0f}, {0.0f, 0.35f, 0.0f}); }

Polygon edge_occluder(float z, const Vec3& target, float angle, float offset, float size) {
  const Vec3 along(std::cos(angle), std::sin(angle), 0.0f);
  const Vec3 across(-along.y, along.x, 0.0f);
  const Vec3 on_edge = kPoint + (z / target.z) * (target - kPoint) + offset * across;
  return parallelogram(on_edge + size * across, size * along, size * across);
}

StressScene transformed(StressScene s, float scale, const Vec3& shift) {
  const auto move = [&](Vec3& p) { p = scale * p + shift; };
  for (PolygonMesh& mesh : s.scene.meshes)
    for (Vec3& p : mesh.positions) move(p);
  for (StressScene::Light& light : s.lights)
    for (Vec3& p : light.corners) move(p);
  for (Polygon& occluder : s.occluders)
    for (Vec3& p : occluder) move(p);
  move(s.ray.origin);
  move(s.scene.camera.origin);
  move(s.scene.camera.target);
  return s;
}

std::string number_label(double value) { return fmt::format("{:g}", value); }

}  // namespace raytracing::stress
