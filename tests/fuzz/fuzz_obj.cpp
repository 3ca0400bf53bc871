// Fuzzes the OBJ parser: the mesh is valid or there is a one-line error with its location, and
// every record is kept or counted as dropped or ignored.

#include "fuzz.h"
#include "raytracing/io/obj.h"
#include "records.h"

namespace raytracing::fuzz {
namespace {

using Severity = LoadReport::Severity;

void check_mesh(const ObjModel& model) {
  const PolygonMesh& mesh = model.mesh;
  std::size_t corners = 0;
  for (const PolygonMesh::Face& face : mesh.faces) {
    require(face.first_corner == corners && face.corner_count >= 3, "faces follow one another");
    require(face.material < model.materials.size(), "a face has a material");
    corners += face.corner_count;
  }
  require(corners == mesh.corners.size(), "every corner is a face's");
  for (const PolygonMesh::Corner& corner : mesh.corners) {
    require(corner.position < mesh.positions.size(), "a corner has a position");
    require(corner.normal == kNone || corner.normal < mesh.normals.size(), "a normal is there");
  }
  for (const auto* list : {&mesh.positions, &mesh.normals})
    for (const Vec3& v : *list) require(is_finite(v), "finite");
}

void check_counts(std::string_view text, const ObjModel& model, const LoadReport& report) {
  auto records = count_records(text, {"usemtl", "mtllib"});
  const auto take = [&](const char* keyword) {
    const std::uint64_t n = records[keyword];
    records.erase(keyword);
    return n;
  };
  require(take("v") == model.mesh.positions.size(), "every v is a position");
  require(take("vn") == model.mesh.normals.size(), "every vn is a normal");
  require(take("f") == model.mesh.faces.size() + count(report, Severity::dropped, "face "),
          "every f is a face or dropped");
  const auto ignored = [&](const char* kind) { return count(report, Severity::ignored, kind); };
  require(take("vt") == ignored("texture coordinate"), "every vt is counted");
  require(take("vp") == ignored("parameter-space vertex"), "every vp is counted");
  require(take("l") == ignored("line"), "every l is counted");
  require(take("p") == ignored("point"), "every p is counted");
  require(take("mtllib") <=
              model.libraries.size() + count(report, Severity::warning, "mtllib without a name"),
          "every mtllib is a library or reported");
  for (const char* silent : {"g", "o", "s", "usemtl"}) take(silent);
  check_ignored(records, report, "unknown keyword");
}

}  // namespace
}  // namespace raytracing::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace raytracing;
  const auto parse = [](const std::string& text, LoadReport& report) {
    const ObjModel model = parse_obj(text, "x.obj", report);
    fuzz::check_mesh(model);
    fuzz::check_counts(text, model, report);
    fuzz::check_report(report, text);
  };
  return fuzz::read_text(data, size, parse, [](const std::string&, std::string_view what) {
    fuzz::check_message(what, "x.obj", true);
  });
}
