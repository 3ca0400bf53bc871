#pragma once
// Helpers of the tests of the OBJ parser.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/told.h"
#include "raytracing/io/obj.h"

namespace raytracing {

/// Four vertices in four lines.
inline const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

struct Parsed {
  ObjModel model;
  LoadReport report;

  const PolygonMesh& mesh() const { return model.mesh; }
  std::size_t faces() const { return model.mesh.faces.size(); }
  std::string told() const { return raytracing::told(report); }
  /// The vertices of a face, counted from 0.
  std::vector<std::uint32_t> vertices(std::size_t face) const {
    std::vector<std::uint32_t> result;
    const auto& f = mesh().faces.at(face);
    for (std::uint32_t i = 0; i < f.corner_count; ++i) {
      result.push_back(mesh().corners.at(f.first_corner + i).position);
    }
    return result;
  }
  std::vector<std::uint32_t> normals(std::size_t face) const {
    std::vector<std::uint32_t> result;
    const auto& f = mesh().faces.at(face);
    for (std::uint32_t i = 0; i < f.corner_count; ++i) {
      result.push_back(mesh().corners.at(f.first_corner + i).normal);
    }
    return result;
  }
  std::string material(std::size_t face) const {
    return model.materials.at(mesh().faces.at(face).material).name;
  }
};

inline Parsed parse(const std::string& text) {
  Parsed parsed;
  parsed.model = parse_obj(text, "x.obj", parsed.report);
  return parsed;
}

/// The error message about the text, which must be one line.
inline std::string error_of(const std::string& text) {
  try {
    parse(text);
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find_first_of("\r\n"), std::string::npos) << "more than one line";
    return what;
  }
  return "no error";
}

using Indices = std::vector<std::uint32_t>;
inline const Indices kQuad{0, 1, 2, 3};

}  // namespace raytracing
