#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/io/errors.h"
#include "raytracing/scene/description.h"

namespace raytracing {

/// A scene file with its assets: the scene, and the default settings of its images.
struct SceneFile {
  SceneDescription scene;
  int width = 784;
  int height = 784;
  std::int64_t spp = 16;
  std::string light_sampling = "solid-angle";  ///< the name of a direct-light method
  std::uint64_t hash = 0;                      ///< hash of the scene file and its OBJ and MTL files
  std::vector<std::string> assets;             ///< paths of the OBJ and MTL files read
};

/// Loads a TOML scene with the OBJ and MTL files that it names. Paths are relative to the scene
/// file, those of MTL files to their OBJ file. `light_sampling_names` are the allowed values of the
/// key light_sampling. Throws InputError (file:line:column); the message about an unknown key names
/// the nearest known one.
SceneFile load_scene_file(const std::string& path,
                          const std::vector<std::string>& light_sampling_names, LoadReport& report);

/// The same for the text of a scene file, whose location is `path`.
SceneFile parse_scene(std::string_view text, const std::string& path,
                      const std::vector<std::string>& light_sampling_names, LoadReport& report);

}  // namespace raytracing
