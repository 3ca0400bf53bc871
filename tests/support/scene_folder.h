#pragma once

#include <string>

#include "raytracing/io/errors.h"
#include "raytracing/io/scene_file.h"
#include "support/temp_dir.h"

namespace raytracing {

/// The shortest valid scene: lines 1 to 3.
inline const std::string kCamera = "[camera]\norigin = [0, 0, 1]\ntarget = [0, 0, 0]\n";

/// A folder with a scene file and its assets.
class SceneFolder {
 public:
  SceneFile load(const std::string& text) {
    report = LoadReport();
    return load_scene_file(folder.write("scene.toml", text), {"area", "solid-angle", "line"},
                           report);
  }

  /// The error that loading gives, without the folder's name; "" for none.
  std::string error(const std::string& text) {
    try {
      load(text);
      return "";
    } catch (const InputError& error) {
      return without_folder(error.what());
    }
  }

  std::string without_folder(std::string text) const {
    const std::string prefix = folder / "";
    for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) {
      text.erase(at, prefix.size());
    }
    return text;
  }

  /// Entries as "severity kind file:line count", in order.
  std::vector<std::string> told() const {
    std::vector<std::string> lines;
    for (const LoadReport::Entry& entry : report.entries()) {
      lines.push_back(without_folder(
          std::string(to_string(entry.severity)) + " " + entry.kind + " " + entry.first.file + ":" +
          std::to_string(entry.first.line) + " " + std::to_string(entry.count)));
    }
    return lines;
  }

  TempDir folder;
  LoadReport report;
};

}  // namespace raytracing
