#include "obj_mesh_builder.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "raytracing/geometry/polygon_mesh.h"

namespace raytracing {
namespace {

using Severity = LoadReport::Severity;

struct RecordCounts {
  std::size_t positions = 0, normals = 0, textures = 0, faces = 0;
  std::size_t words = 0;  // behind keywords
};

// Counts roughly and fast, so that each array is allocated once. Wrong counts, for files with an
// odd layout, cost address space or time but nothing else. The blocks are short enough for sums in
// bytes, which let compilers vectorize the loop.
RecordCounts count_records(std::string_view text) {
  constexpr std::size_t kBlock = 224;
  const auto count = [](std::uint8_t& sum, bool one) {
    sum = static_cast<std::uint8_t>(sum + one);
  };
  RecordCounts counts;
  for (std::size_t start = 0; start + 2 < text.size(); start += kBlock) {
    const char* const at = text.data() + start;
    const std::size_t size = std::min(kBlock, text.size() - 2 - start);
    std::uint8_t positions = 0, normals = 0, textures = 0, faces = 0, words = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const bool line = (at[i] == '\n') | (at[i] == '\r');
      const bool v = line & (at[i + 1] == 'v');
      const bool blank = (at[i + 2] == ' ') | (at[i + 2] == '\t');
      count(positions, v & blank);
      count(normals, v & (at[i + 2] == 'n'));
      count(textures, v & (at[i + 2] == 't'));
      count(faces, line & (at[i + 1] == 'f') & blank);
      count(words, ((at[i] == ' ') | (at[i] == '\t')) & (at[i + 1] > ' '));
    }
    counts.positions += positions;
    counts.normals += normals;
    counts.textures += textures;
    counts.faces += faces;
    counts.words += words;
  }
  return counts;
}

}  // namespace

void ObjMeshBuilder::reserve_for(std::string_view text) {
  const RecordCounts counts = count_records(text);
  const std::size_t others = 3 * counts.positions + 3 * counts.normals + 2 * counts.textures;
  // One more each, since no line end precedes the first line.
  mesh_.positions.reserve(counts.positions + 1);
  mesh_.normals.reserve(counts.normals + 1);
  mesh_.faces.reserve(counts.faces + 1);
  mesh_.corners.reserve(counts.words - std::min(counts.words, others) + 3);
}

void ObjMeshBuilder::add_normal(Vec3 normal, const TextPlace& where) {
  const float squared = dot(normal, normal);
  if (normal == Vec3(0.0f)) {
    report_.add(Severity::repaired, "normal of length zero", file_, where);
    has_zero_normals_ = true;
  } else if (!(squared >= FLT_MIN && squared <= FLT_MAX)) {
    normal /= max_component(absolute(normal));  // or normalizing it would give 0 or NaN
  }
  mesh_.normals.push_back(normal);
}

void ObjMeshBuilder::end_face(std::uint32_t material, const TextPlace& where) {
  if (is_plain_triangle()) return add_face(material);
  const bool repeated = remove_repeated_corners();
  const std::size_t count = mesh_.corners.size() - first_corner_;
  const bool late = is_late();
  const char* fault = nullptr;
  if (count < 3)
    fault = "face with fewer than 3 different corners";
  else if (!late && !has_area(first_corner_, count))
    fault = "face without area";
  if (fault) {
    mesh_.corners.resize(first_corner_, {});
    report_.add(Severity::dropped, fault, file_, where);
    return;
  }
  if (repeated) report_.add(Severity::repaired, "face with a repeated corner", file_, where);
  if (late) late_faces_.push_back({static_cast<std::uint32_t>(mesh_.faces.size()), where});
  add_face(material);
}

void ObjMeshBuilder::add_face(std::uint32_t material) {
  const std::size_t count = mesh_.corners.size() - first_corner_;
  mesh_.faces.push_back(
      {static_cast<std::uint32_t>(first_corner_), static_cast<std::uint32_t>(count), material});
  first_corner_ = mesh_.corners.size();
}

// Whether the face is a triangle of known vertices whose area is certainly not zero: a component of
// its cross product exceeds the rounding error of zero in double precision.
bool ObjMeshBuilder::is_plain_triangle() const {
  if (mesh_.corners.size() != first_corner_ + 3) return false;
  const PolygonMesh::Corner* const corners = &mesh_.corners[first_corner_];
  const std::size_t known = mesh_.positions.size();
  for (int i = 0; i < 3; ++i)
    if (corners[i].position >= known) return false;
  const DVec3 a(mesh_.positions[corners[0].position]);
  const DVec3 u = DVec3(mesh_.positions[corners[1].position]) - a;
  const DVec3 v = DVec3(mesh_.positions[corners[2].position]) - a;
  const auto differ = [](double p, double q) {
    return std::abs(p - q) > 1e-15 * (std::abs(p) + std::abs(q));
  };
  return differ(u.y * v.z, u.z * v.y) || differ(u.z * v.x, u.x * v.z) ||
         differ(u.x * v.y, u.y * v.x);
}

// Keeps one of each run of corners at the same vertex, where the first corner follows the last.
bool ObjMeshBuilder::remove_repeated_corners() {
  auto& corners = mesh_.corners;
  const std::size_t before = corners.size();
  const auto same = [](const auto& a, const auto& b) { return a.position == b.position; };
  corners.erase(std::unique(corners.begin() + first_corner_, corners.end(), same), corners.end());
  while (corners.size() > first_corner_ + 1 && same(corners.back(), corners[first_corner_]))
    corners.pop_back();
  return corners.size() < before;
}

bool ObjMeshBuilder::is_late() const {
  return std::any_of(mesh_.corners.begin() + first_corner_, mesh_.corners.end(),
                     [&](const auto& corner) { return corner.position >= mesh_.positions.size(); });
}

bool ObjMeshBuilder::has_area(std::size_t first, std::size_t count) {
  outline_.clear();
  for (std::size_t i = first; i < first + count; ++i)
    outline_.push_back(mesh_.positions[mesh_.corners[i].position]);
  return newell_normal(outline_) != DVec3(0.0);
}

PolygonMesh ObjMeshBuilder::finish() {
  if (!late_faces_.empty()) drop_late_faces();
  if (has_zero_normals_) forget_zero_normals();
  return std::move(mesh_);
}

void ObjMeshBuilder::drop_late_faces() {
  auto late = late_faces_.begin();
  std::size_t kept_faces = 0;
  std::size_t kept_corners = 0;
  for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
    PolygonMesh::Face face = mesh_.faces[i];
    if (late != late_faces_.end() && late->face == i) {
      const TextPlace where = (late++)->where;
      if (!has_area(face.first_corner, face.corner_count)) {
        report_.add(Severity::dropped, "face without area", file_, where);
        continue;
      }
    }
    const auto from = mesh_.corners.begin() + face.first_corner;
    std::copy(from, from + face.corner_count, mesh_.corners.begin() + kept_corners);
    face.first_corner = static_cast<std::uint32_t>(kept_corners);
    kept_corners += face.corner_count;
    mesh_.faces[kept_faces++] = face;
  }
  mesh_.faces.resize(kept_faces);
  mesh_.corners.resize(kept_corners, {});
}

void ObjMeshBuilder::forget_zero_normals() {
  for (PolygonMesh::Corner& corner : mesh_.corners)
    if (corner.normal != kNone && mesh_.normals[corner.normal] == Vec3(0.0f)) corner.normal = kNone;
}

}  // namespace raytracing
