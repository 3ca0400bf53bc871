#include "raytracing/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "raytracing/geometry/polygon_mesh.h"

namespace raytracing {
namespace {

// Returns the largest distance of a corner from the mean plane of the polygon, relative to its
// size.
double relative_flatness(std::span<const Vec3> corners, const DVec3& normal) {
  DVec3 center(0.0);
  for (const Vec3& c : corners) center += DVec3(c) / static_cast<double>(corners.size());
  double height = 0, size = 0;
  for (const Vec3& c : corners) {
    const DVec3 d = DVec3(c) - center;
    height = std::max(height, std::abs(dot(d, normal)));
    size = std::max(size, length(d));
  }
  return height / size;
}

// An area light must be planar and convex. The tolerance is the rounding of corners that a text
// file stores with six or seven digits.
bool can_be_one_light(std::span<const Vec3> corners) {
  const DVec3 normal = newell_normal(corners);
  return is_convex(corners) && relative_flatness(corners, normalize(normal)) < 1e-5;
}

DVec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const DVec3 n = cross(DVec3(b) - DVec3(a), DVec3(c) - DVec3(a));
  const double l = length(n);
  // Embree never reports a hit on a triangle of zero area, so that any direction will do.
  return l > 0 ? n / l : DVec3(0, 0, 1);
}

// Returns the defensive mixture of sampling by power and uniform sampling.
DiscreteDistribution light_distribution(std::vector<float> powers) {
  double sum = 0;
  for (const float power : powers) sum += static_cast<double>(power);
  const double even =
      sum / static_cast<double>(powers.size()) * kEvenLightShare / (1 - kEvenLightShare);
  for (float& power : powers) power += static_cast<float>(even);
  return DiscreteDistribution(powers);
}

}  // namespace

// The parts of a Scene while they are built from its description.
struct Scene::Builder {
  explicit Builder(SceneDescription description);

  std::vector<Material> materials;
  std::vector<std::uint32_t> sphere_materials;
  std::vector<TriangleRecord> records;
  std::vector<SmoothNormals> smooth_normals;
  std::vector<AreaLight> lights;
  CameraDescription camera;
  Vec3 origin;
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

  std::vector<Vec3> face_positions_;  // scratch memory of add_face
};

Scene::Builder::Builder(SceneDescription description)
    : camera(description.camera), origin(description.origin) {
  for (const Surface& surface : description.surfaces) materials.push_back(surface.material);
  for (const SphereDescription& sphere : description.spheres) {
    spheres.push_back({sphere.center, sphere.radius});
    sphere_materials.push_back(sphere.surface);
  }
  std::size_t triangle_count = 0, smooth_count = 0, position_count = 0;
  for (const PolygonMesh& mesh : description.meshes) {
    const std::size_t count = mesh.corners.size() - 2 * mesh.faces.size();
    triangle_count += count;
    if (!mesh.normals.empty()) smooth_count += count;
    position_count += mesh.positions.size();
  }
  records.reserve(triangle_count);
  triangles.reserve(triangle_count);
  smooth_normals.reserve(smooth_count);
  positions.reserve(position_count + 1);  // EmbreeScene appends one
  for (PolygonMesh& mesh : description.meshes) {
    add_mesh(mesh, description.surfaces);
    mesh = {};  // large scenes need the memory
  }
}

void Scene::Builder::add_mesh(const PolygonMesh& mesh, std::span<const Surface> surfaces) {
  const auto base = static_cast<std::uint32_t>(positions.size());
  positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const PolygonMesh::Face& face : mesh.faces)
    add_face(mesh, face, base, surfaces[face.material]);
}

void Scene::Builder::add_face(const PolygonMesh& mesh, const PolygonMesh::Face& face,
                              std::uint32_t base, const Surface& surface) {
  const PolygonMesh::Corner* corners = &mesh.corners[face.first_corner];
  face_positions_.clear();
  for (std::uint32_t i = 0; i < face.corner_count; ++i)
    face_positions_.push_back(mesh.positions[corners[i].position]);

  const bool emits = !is_black(surface.Le);
  std::uint32_t light = kNone;
  const bool one_light = emits && can_be_one_light(face_positions_);
  if (one_light) light = add_light(face_positions_, surface.Le);
  if (emits && !one_light) ++notes.split_lights;

  for (const std::array<std::uint32_t, 3>& t : triangulate(face_positions_)) {
    TriangleRecord record;
    float max_coordinate = 0;
    EmbreeScene::Triangle indices;
    const PolygonMesh::Corner* triangle_corners[3];
    for (int i = 0; i < 3; ++i) {
      record.corners[i] = face_positions_[t[i]];
      max_coordinate = std::max(max_coordinate, max_component(absolute(record.corners[i])));
      triangle_corners[i] = &corners[t[i]];
      indices.corners[i] = base + corners[t[i]].position;
    }
    record.ng = Vec3(unit_normal(record.corners[0], record.corners[1], record.corners[2]));
    record.error = position_error(max_coordinate);
    record.surface = face.material;
    record.light = emits && !one_light ? add_light(record.corners, surface.Le) : light;
    record.normals = add_normals(mesh, triangle_corners, record.ng);
    records.push_back(record);
    triangles.push_back(indices);
  }
}

std::uint32_t Scene::Builder::add_light(std::span<const Vec3> corners, const Rgb& Le) {
  if (!(length(newell_normal(corners)) > 0)) {
    ++notes.zero_area_lights;
    return kNone;
  }
  lights.emplace_back(corners, Le);
  return static_cast<std::uint32_t>(lights.size() - 1);
}

std::uint32_t Scene::Builder::add_normals(const PolygonMesh& mesh,
                                          const PolygonMesh::Corner* const corners[3],
                                          const Vec3& ng) {
  SmoothNormals smooth;
  for (int i = 0; i < 3; ++i) {
    if (corners[i]->normal == kNone) return kNone;
    smooth.corners[i] = normalize(mesh.normals[corners[i]->normal]);
  }
  // The winding order defines the front side of a face; normals on the other side are flipped.
  if (dot(smooth.corners[0] + smooth.corners[1] + smooth.corners[2], ng) < 0)
    for (Vec3& n : smooth.corners) n = -n;
  smooth_normals.push_back(smooth);
  return static_cast<std::uint32_t>(smooth_normals.size() - 1);
}

Scene::Scene(SceneDescription description, int threads, bool with_occluders)
    : Scene(Builder(std::move(description)), threads, with_occluders) {}

Scene::Scene(Builder&& b, int threads, bool with_occluders)
    : materials_(std::move(b.materials)),
      sphere_materials_(std::move(b.sphere_materials)),
      triangles_(std::move(b.records)),
      smooth_normals_(std::move(b.smooth_normals)),
      lights_(std::move(b.lights)),
      camera_(b.camera),
      origin_(b.origin),
      notes_(b.notes),
      geometry_(std::move(b.positions), std::move(b.triangles), std::move(b.spheres), threads) {
  std::vector<float> powers;
  for (const AreaLight& light : lights_) {
    powers.push_back(light.power());
    if (!faces_anything(light)) ++notes_.lights_facing_nothing;
  }
  light_choice_ = light_distribution(std::move(powers));
  if (!with_occluders) return;
  std::vector<std::uint32_t> light_of_triangle;
  for (const TriangleRecord& t : triangles_) light_of_triangle.push_back(t.light);
  occluders_ = OccluderTree(geometry_.positions(), geometry_.triangles(), light_of_triangle,
                            geometry_.spheres(), threads);
}

bool Scene::faces_anything(const AreaLight& light) const {
  constexpr float kRoundings = 8;  // tolerance for surfaces that lie in the plane of the light
  const auto is_in_front = [&](const Vec3& p, float radius) {
    return dot(p - light.corners[0], light.normal) + radius > kRoundings * light.error;
  };
  if (is_in_front(camera_.origin, 0)) return true;
  for (const Vec3& p : geometry_.positions())
    if (is_in_front(p, 0)) return true;
  for (const Sphere& s : geometry_.spheres())
    if (is_in_front(s.center, s.radius)) return true;
  return false;
}

}  // namespace raytracing
