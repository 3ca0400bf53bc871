#include "obj_mesh_builder.h"

#include <algorithm>
#include <cfloat>

#include "raytracing/geometry/triangulate.h"

namespace raytracing {
namespace {

using Severity = LoadReport::Severity;

struct RecordCounts {
  std::size_t positions = 0, normals = 0, faces = 0, corners = 0;
};

// A quick look over the text, so that each array is allocated once and at about its final size.
// Files with odd layout are counted wrong, which costs memory or time but nothing else.
RecordCounts count_records(std::string_view text) {
  RecordCounts counts;
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const char first = text[at];
    const char second = text[at + 1];
    if (first == 'f' && second == ' ') {
      ++counts.faces;
      std::size_t corners = 0;
      for (++at; at < text.size() && text[at] != '\n'; ++at) {
        corners += text[at - 1] == ' ' && text[at] > ' ';
      }
      counts.corners += corners;
      continue;
    }
    if (first == 'v') {
      counts.positions += second == ' ';
      counts.normals += second == 'n';
    }
    at = text.find('\n', at);
    if (at == std::string_view::npos) break;
  }
  return counts;
}

}  // namespace

void ObjMeshBuilder::reserve_for(std::string_view text) {
  const RecordCounts counts = count_records(text);
  mesh_.positions.reserve(counts.positions);
  mesh_.normals.reserve(counts.normals);
  mesh_.faces.reserve(counts.faces);
  mesh_.corners.reserve(counts.corners);
}

void ObjMeshBuilder::add_normal(Vec3 normal, const TextPlace& where) {
  const float squared = dot(normal, normal);
  if (normal == Vec3(0.0f)) {
    tally_.note(Severity::repaired, "normal of length zero", where);
    has_zero_normals_ = true;
  } else if (!(squared >= FLT_MIN && squared <= FLT_MAX)) {
    normal /= max_component(absolute(normal));  // or normalizing it would give 0 or NaN
  }
  mesh_.normals.push_back(normal);
}

void ObjMeshBuilder::end_face(std::uint32_t material, const TextPlace& where) {
  const bool repeated = remove_repeated_corners();
  const std::size_t count = mesh_.corners.size() - first_corner_;
  const bool late = is_late();
  const char* fault = nullptr;
  if (count < 3) {
    fault = "face with fewer than 3 different corners";
  } else if (!late && !has_area(first_corner_, count)) {
    fault = "face without area";
  }
  if (fault) {
    mesh_.corners.resize(first_corner_, {});
    tally_.note(Severity::dropped, fault, where);
    return;
  }
  if (repeated) tally_.note(Severity::repaired, "face with a repeated corner", where);
  if (late) late_faces_.push_back({static_cast<std::uint32_t>(mesh_.faces.size()), where});
  mesh_.faces.push_back({static_cast<std::uint32_t>(first_corner_),
                         static_cast<std::uint32_t>(count), material});
  first_corner_ = mesh_.corners.size();
}

// Leaves one of each run of corners at the same vertex; the last corner stands before the first.
bool ObjMeshBuilder::remove_repeated_corners() {
  auto& corners = mesh_.corners;
  const std::size_t before = corners.size();
  const auto same = [](const auto& a, const auto& b) { return a.position == b.position; };
  corners.erase(std::unique(corners.begin() + first_corner_, corners.end(), same), corners.end());
  while (corners.size() > first_corner_ + 1 && same(corners.back(), corners[first_corner_])) {
    corners.pop_back();
  }
  return corners.size() < before;
}

bool ObjMeshBuilder::is_late() const {
  return std::any_of(mesh_.corners.begin() + first_corner_, mesh_.corners.end(),
                     [&](const auto& corner) { return corner.position >= mesh_.positions.size(); });
}

bool ObjMeshBuilder::has_area(std::size_t first, std::size_t count) {
  outline_.clear();
  for (std::size_t i = first; i < first + count; ++i) {
    outline_.push_back(mesh_.positions[mesh_.corners[i].position]);
  }
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
        tally_.note(Severity::dropped, "face without area", where);
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
  for (PolygonMesh::Corner& corner : mesh_.corners) {
    if (corner.normal != kNone && mesh_.normals[corner.normal] == Vec3(0.0f)) corner.normal = kNone;
  }
}

}  // namespace raytracing
