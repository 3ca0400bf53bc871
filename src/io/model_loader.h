#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "raytracing/geometry/polygon_mesh.h"
#include "raytracing/io/mtl.h"
#include "raytracing/io/obj.h"
#include "raytracing/io/scene_file.h"

namespace raytracing {

/// Scales a model, then rotates it, then translates it.
struct Transform {
  DVec3 scale{1.0};   ///< along x, y, z; none zero
  DVec3 rotate{0.0};  ///< degrees about x, then y, then z; right-handed
  DVec3 translate{0.0};
};

/// Moves a mesh. Normals follow the inverse transpose and become unit vectors. A transform that
/// mirrors reverses the corners of each face, so that winding and normals still agree. Computed in
/// double and rounded once. A coordinate beyond the range of a float becomes infinite.
void apply(const Transform& transform, PolygonMesh& mesh);

/// A model that a scene file asks for.
struct ModelRequest {
  std::string path;    ///< path of the OBJ file
  TextLocation where;  ///< location of the path in the scene file
  Transform transform;
  std::optional<std::uint32_t> surface;  ///< replaces all materials of the model
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
    std::map<std::string, std::uint32_t> surfaces;  ///< surfaces of the materials used so far
  };

  void load(const ModelRequest& request);
  std::string read_asset(const std::string& path);
  Model& model(const ModelRequest& request);
  /// Returns null if there is no such file.
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

}  // namespace raytracing
