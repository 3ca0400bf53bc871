#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/io/load_report.h"
#include "raytracing/scene/description.h"

namespace raytracing {

/// A scene file with its assets read: the scene, and the settings that the file proposes.
struct SceneFile {
  SceneDescription scene;
  int width = 784;
  int height = 784;
  std::int64_t spp = 16;
  std::string light_sampling = "solid-angle";  ///< a name of the table of direct-light methods
  std::uint64_t hash = 0;                      ///< of the scene file and all its OBJ and MTL files
  std::vector<std::string> assets;             ///< paths of the OBJ and MTL files read
};

/// Loads a TOML scene and the OBJ and MTL files it names (paths relative to the scene file; MTL
/// paths relative to their OBJ). `light_sampling_names` are the values that key may have.
/// Throws InputError (file:line:column); an unknown key's message names the nearest known key.
SceneFile load_scene_file(const std::string& path,
                          const std::vector<std::string>& light_sampling_names, LoadReport& report);

/// The same for a scene file's text; `path` says where it lies.
SceneFile parse_scene(std::string_view text, const std::string& path,
                      const std::vector<std::string>& light_sampling_names, LoadReport& report);

}  // namespace raytracing
