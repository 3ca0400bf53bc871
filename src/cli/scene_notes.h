#pragma once

#include "raytracing/io/scene_file.h"
#include "raytracing/scene/scene.h"

namespace raytracing {

/// Tells on stderr what loading changed or left out. With `quiet`, not what was merely ignored.
/// Throws InputError when `strict` and anything was repaired or dropped.
void print_load_report(const LoadReport& report, const SceneFile& scene, bool quiet, bool strict);

/// The same for building the scene.
void print_scene_notes(const Scene& scene, bool quiet, bool strict);

}  // namespace raytracing
