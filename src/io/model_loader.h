#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "raytracing/io/mtl.h"
#include "raytracing/io/obj.h"
#include "raytracing/io/scene_file.h"
#include "transform.h"

namespace raytracing {

/// One model that a scene file asks for.
struct ModelRequest {
  std::string path;    ///< of the OBJ file
  TextLocation where;  ///< where the scene file names it
  Transform transform;
  std::optional<std::uint32_t> surface;  ///< takes the place of all its materials
};

/// Adds models to a scene file: meshes, surfaces, and the names and hash of the files read. Reads
/// each file once, however many models use it.
class ModelLoader {
 public:
  ModelLoader(SceneFile& file, LoadReport& report) : file_(file), report_(report) {}

  /// Throws InputError.
  void load(std::span<const ModelRequest> requests);

 private:
  /// An OBJ file and, once some model needs them, the surfaces of its materials.
  struct Model {
    ObjModel obj;
    std::optional<std::vector<std::uint32_t>> surfaces;
    std::size_t uses_left;
  };
  struct Library {
    std::vector<MtlMaterial> materials;
    std::map<std::string, std::uint32_t> surfaces;  ///< of the materials used so far, by name
  };

  void load(const ModelRequest& request);
  std::string read_asset(const std::string& path);
  Model& model(const ModelRequest& request);
  /// Null when there is no such file.
  Library* library(const std::string& path);
  std::vector<std::uint32_t> resolve_materials(const ObjModel& obj, const std::string& obj_path);
  std::uint32_t resolve_material(const ObjModel::MaterialUse& use,
                                 const std::vector<Library*>& libraries);
  std::uint32_t add_surface(Surface surface);
  std::uint32_t default_surface();

  SceneFile& file_;
  LoadReport& report_;
  std::map<std::string, std::size_t> uses_;  // of each OBJ file
  std::map<std::string, Model> models_;
  std::map<std::string, Library> libraries_;
  std::optional<std::uint32_t> default_surface_;
};

}  // namespace raytracing
