#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "raytracing/io/scene_file.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// Scales a model, then rotates it, then translates it.
struct Transform {
  DVec3 scale{1.0};   ///< along x, y, z; none zero
  DVec3 rotate{0.0};  ///< degrees about x, then y, then z; right-handed
  DVec3 translate{0.0};
};

/// A model that a scene file asks for.
struct ModelRequest {
  std::string path;    ///< path of the OBJ file
  TextLocation where;  ///< location of the path in the scene file
  Transform transform;
  std::optional<std::uint32_t> surface;  ///< replaces all materials of the model
};

/// Adds models to a scene file: meshes, surfaces, and the names and hash of the files read. Reads
/// each file once, however many models use it. Throws InputError.
void load_models(std::span<const ModelRequest> requests, SceneFile& file, LoadReport& report);

}  // namespace raytracing
