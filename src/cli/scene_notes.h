#pragma once

#include "raytracing/io/scene_file.h"
#include "raytracing/scene/scene.h"

namespace raytracing {

/// Tells on stderr what loading changed or left out. With `quiet`, not what was merely ignored.
/// Throws InputError when `strict` and anything was repaired or dropped.
void print_load_report(const LoadReport& report, const SceneFile& scene, bool quiet, bool strict);

/// Moves a scene that lies far from the origin of coordinates there, and returns what it subtracted
/// from all positions. Warns on stderr when the scene's own coordinates had no digits left.
Vec3 bring_near(SceneDescription& scene);

/// Warns on stderr where the pixels of a camera are so narrow that the rounding of rays shows: from
/// some 1e4 times as far as what it sees is large.
void warn_of_narrow_pixels(const CameraDescription& camera, int height);

/// The same as print_load_report for building the scene.
void print_scene_notes(const Scene& scene, bool quiet, bool strict);

}  // namespace raytracing
