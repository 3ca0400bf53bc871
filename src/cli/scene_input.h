#pragma once
// A scene on its way from its name on the command line to the renderer.

#include <optional>
#include <string>
#include <vector>

#include "raytracing/io/scene_file.h"
#include "raytracing/scene/scene.h"

namespace raytracing {

/// Returns the paths at which a scene is looked up, in order: its name and, unless that has a
/// directory, the name with the extension .toml, there and in the folder of the scenes that come
/// with the program. That folder is <prefix>/share/raytracing/scenes for a program in <prefix>/bin,
/// and
/// ../scenes for a program in a build tree.
std::vector<std::string> scene_candidates(const std::string& name);

/// Returns the first of scene_candidates() that exists, if any.
std::optional<std::string> find_scene(const std::string& name);

/// Loads and builds a scene, and reports on stderr what was repaired, dropped, ignored or doubtful.
class SceneInput {
 public:
  /// Loads the scene file. With `quiet`, reports neither sizes nor what was ignored. Throws
  /// InputError, also if `strict` and something was repaired or dropped.
  SceneInput(const std::string& path, bool quiet, bool strict);

  const SceneFile& file() const { return file_; }
  double load_seconds() const { return load_seconds_; }

  /// Builds the scene for images of this height, moved to the origin of coordinates where it lies
  /// far from there; call it once. `with_occluders` as for Scene.
  /// Throws InputError if `strict` and lights were repaired or dropped.
  const Scene& build(int image_height, int threads, bool with_occluders);
  double build_seconds() const { return build_seconds_; }

 private:
  void report_loading(const std::string& path, const LoadReport& report) const;
  void report_building() const;

  bool quiet_, strict_;
  SceneFile file_;
  std::optional<Scene> scene_;
  double load_seconds_ = 0, build_seconds_ = 0;
};

}  // namespace raytracing
