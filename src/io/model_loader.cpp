#include "model_loader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "raytracing/io/file.h"
#include "raytracing/io/mtl.h"
#include "raytracing/io/obj.h"

namespace raytracing {
namespace {

// Returns the path of `name` relative to the folder of the file `from`.
std::string beside(const std::string& from, const std::string& name) {
  return (std::filesystem::path(from).parent_path() / name).lexically_normal().string();
}

// Sine and cosine, exact at multiples of 90 degrees, so that axis-aligned walls stay aligned.
struct Angle {
  explicit Angle(double degrees) {
    const double quarters = std::nearbyint(degrees / 90);
    const double rest = (degrees - 90 * quarters) * (3.14159265358979323846 / 180);
    const double s = std::sin(rest), c = std::cos(rest);
    const double turn = quarters - 4 * std::floor(quarters / 4);  // 0, 1, 2 or 3
    sine = turn == 0 ? s : turn == 1 ? c : turn == 2 ? -s : -c;
    cosine = turn == 0 ? c : turn == 1 ? -s : turn == 2 ? -c : s;
  }
  double sine, cosine;
};

DVec3 rotated(DVec3 v, const Angle& x, const Angle& y, const Angle& z) {
  v = {v.x, x.cosine * v.y - x.sine * v.z, x.sine * v.y + x.cosine * v.z};
  v = {y.cosine * v.x + y.sine * v.z, v.y, y.cosine * v.z - y.sine * v.x};
  v = {z.cosine * v.x - z.sine * v.y, z.sine * v.x + z.cosine * v.y, v.z};
  return v;
}

// Moves a mesh. Normals follow the inverse transpose and become unit vectors. A transform that
// mirrors reverses the corners of each face, so that winding and normals still agree. Computed in
// double and rounded once. A coordinate beyond the range of a float becomes infinite.
void apply(const Transform& transform, PolygonMesh& mesh) {
  const Angle x(transform.rotate.x), y(transform.rotate.y), z(transform.rotate.z);
  for (Vec3& position : mesh.positions) {
    const DVec3 scaled = transform.scale * DVec3(position);
    position = Vec3(rotated(scaled, x, y, z) + transform.translate);
  }
  for (Vec3& normal : mesh.normals) {
    // The inverse transpose of rotation times scale is rotation times 1 / scale.
    const DVec3 moved = rotated(DVec3(normal) / transform.scale, x, y, z);
    const double norm = length(moved);
    if (norm > 0) normal = Vec3(moved / norm);
  }
  const DVec3& s = transform.scale;
  const int mirrors = (s.x < 0 ? 1 : 0) + (s.y < 0 ? 1 : 0) + (s.z < 0 ? 1 : 0);
  if (mirrors % 2 == 0) return;
  for (const PolygonMesh::Face& face : mesh.faces) {
    const auto first = mesh.corners.begin() + static_cast<std::ptrdiff_t>(face.first_corner);
    std::reverse(first, first + static_cast<std::ptrdiff_t>(face.corner_count));
  }
}

// The steps of load_models() and the files read so far.
class ModelLoader {
 public:
  ModelLoader(SceneFile& file, LoadReport& report) : file_(file), report_(report) {}

  void load(std::span<const ModelRequest> requests);

 private:
  // An OBJ file and, once some model needs them, the surfaces of its materials.
  struct Model {
    ObjModel obj;
    std::optional<std::vector<std::uint32_t>> surfaces;
    std::size_t uses_left;
  };
  struct Library {
    std::vector<MtlMaterial> materials;
    std::map<std::string, std::uint32_t> surfaces;  // surfaces of the materials used so far
  };

  void load(const ModelRequest& request);
  std::string read_asset(const std::string& path);
  Model& model(const ModelRequest& request);
  // Returns null if there is no such file.
  Library* library(const std::string& path);
  std::vector<std::uint32_t> resolve_materials(const ObjModel& obj, const std::string& obj_path);
  std::uint32_t resolve_material(const ObjModel::MaterialUse& use,
                                 const std::vector<Library*>& libraries);
  std::uint32_t add_surface(Surface surface);
  std::uint32_t default_surface();

  SceneFile& file_;
  LoadReport& report_;
  std::map<std::string, std::size_t> uses_;  // how many models use each OBJ file
  std::map<std::string, Model> models_;
  std::map<std::string, Library> libraries_;
  std::optional<std::uint32_t> default_surface_;
};

void ModelLoader::load(std::span<const ModelRequest> requests) {
  for (const ModelRequest& request : requests) ++uses_[request.path];
  for (const ModelRequest& request : requests) load(request);
}

void ModelLoader::load(const ModelRequest& request) {
  Model& source = model(request);
  const bool last = --source.uses_left == 0;
  PolygonMesh mesh = last ? std::move(source.obj.mesh) : source.obj.mesh;
  apply(request.transform, mesh);
  if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite<float>))
    throw InputError(request.where, "the transform moves vertices beyond the range of a float");
  if (!request.surface && !source.surfaces)
    source.surfaces = resolve_materials(source.obj, request.path);
  for (PolygonMesh::Face& face : mesh.faces)
    face.material = request.surface ? *request.surface : source.surfaces->at(face.material);
  file_.scene.meshes.push_back(std::move(mesh));
}

std::string ModelLoader::read_asset(const std::string& path) {
  std::string bytes = read_file(path);
  file_.assets.push_back(path);
  file_.hash = hash_bytes(bytes, file_.hash);
  return bytes;
}

ModelLoader::Model& ModelLoader::model(const ModelRequest& request) {
  const auto known = models_.find(request.path);
  if (known != models_.end()) return known->second;
  std::string text;
  try {
    text = read_asset(request.path);
  } catch (const InputError& error) {
    throw InputError(request.where, error.what());
  }
  ObjModel obj = parse_obj(text, request.path, report_);
  drop_unused_positions(obj.mesh);  // they would enlarge the bounds of the scene and its rounding
  Model made{std::move(obj), {}, uses_[request.path]};
  return models_.emplace(request.path, std::move(made)).first->second;
}

ModelLoader::Library* ModelLoader::library(const std::string& path) {
  const auto known = libraries_.find(path);
  if (known != libraries_.end()) return &known->second;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return nullptr;
  std::vector<MtlMaterial> materials = parse_mtl(read_asset(path), path, report_);
  return &libraries_.emplace(path, Library{std::move(materials), {}}).first->second;
}

std::vector<std::uint32_t> ModelLoader::resolve_materials(const ObjModel& obj,
                                                          const std::string& obj_path) {
  std::vector<Library*> libraries;
  for (const ObjModel::Library& named : obj.libraries) {
    if (Library* found = library(beside(obj_path, named.name))) {
      libraries.push_back(found);
    } else {
      report_.add(LoadReport::Severity::repaired, "material library missing", named.where,
                  raytracing::quoted(named.name));
    }
  }
  std::vector<std::uint32_t> surfaces;
  for (const ObjModel::MaterialUse& use : obj.materials)
    surfaces.push_back(resolve_material(use, libraries));
  return surfaces;
}

std::uint32_t ModelLoader::resolve_material(const ObjModel::MaterialUse& use,
                                            const std::vector<Library*>& libraries) {
  if (use.name.empty()) return default_surface();
  for (Library* library : libraries) {  // the first definition is used
    const auto known = library->surfaces.find(use.name);
    if (known != library->surfaces.end()) return known->second;
    for (const MtlMaterial& material : library->materials) {
      if (material.name != use.name) continue;
      const std::uint32_t surface = add_surface(surface_from_mtl(material, report_));
      library->surfaces.emplace(use.name, surface);
      return surface;
    }
  }
  report_.add(LoadReport::Severity::repaired, "material not defined", use.where,
              raytracing::quoted(use.name));
  return default_surface();
}

std::uint32_t ModelLoader::add_surface(Surface surface) {
  file_.scene.surfaces.push_back(std::move(surface));
  return static_cast<std::uint32_t>(file_.scene.surfaces.size() - 1);
}

std::uint32_t ModelLoader::default_surface() {
  if (!default_surface_) default_surface_ = add_surface({"default", Diffuse{}, Rgb(0.0f)});
  return *default_surface_;
}

}  // namespace

void load_models(std::span<const ModelRequest> requests, SceneFile& file, LoadReport& report) {
  ModelLoader(file, report).load(requests);
}

}  // namespace raytracing
