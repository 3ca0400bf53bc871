#include "model_loader.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "mtl_surface.h"
#include "raytracing/io/file.h"
#include "text_cursor.h"

namespace raytracing {
namespace {

/// `name` as seen from the folder of the file `from`.
std::string beside(const std::string& from, const std::string& name) {
  return (std::filesystem::path(from).parent_path() / name).lexically_normal().string();
}

}  // namespace

void ModelLoader::load(std::span<const ModelRequest> requests) {
  for (const ModelRequest& request : requests) ++uses_[request.path];
  for (const ModelRequest& request : requests) load(request);
}

void ModelLoader::load(const ModelRequest& request) {
  Model& source = model(request);
  const bool last = --source.uses_left == 0;
  PolygonMesh mesh = last ? std::move(source.obj.mesh) : source.obj.mesh;
  apply(request.transform, mesh);
  if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite<float>)) {
    throw InputError(request.where, "the transform moves vertices beyond the range of a float");
  }
  if (!request.surface && !source.surfaces) {
    source.surfaces = resolve_materials(source.obj, request.path);
  }
  for (PolygonMesh::Face& face : mesh.faces) {
    face.material = request.surface ? *request.surface : source.surfaces->at(face.material);
  }
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
  drop_unused_positions(obj.mesh);  // they would count to the scene's bounds and its rounding
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
      report_.add(LoadReport::Severity::repaired, "material library missing", named.where, 1,
                  raytracing::quoted(named.name));
    }
  }
  std::vector<std::uint32_t> surfaces;
  for (const ObjModel::MaterialUse& use : obj.materials) {
    surfaces.push_back(resolve_material(use, libraries));
  }
  return surfaces;
}

std::uint32_t ModelLoader::resolve_material(const ObjModel::MaterialUse& use,
                                            const std::vector<Library*>& libraries) {
  if (use.name.empty()) return default_surface();
  for (Library* library : libraries) {  // the first definition counts
    const auto known = library->surfaces.find(use.name);
    if (known != library->surfaces.end()) return known->second;
    for (const MtlMaterial& material : library->materials) {
      if (material.name != use.name) continue;
      const std::uint32_t surface = add_surface(surface_from_mtl(material, report_));
      library->surfaces.emplace(use.name, surface);
      return surface;
    }
  }
  report_.add(LoadReport::Severity::repaired, "material not defined", use.where, 1,
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

}  // namespace raytracing
