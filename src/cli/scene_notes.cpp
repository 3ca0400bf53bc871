#include "scene_notes.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "raytracing/io/errors.h"
#include "raytracing/math/numeric.h"
#include "raytracing/scene/far_scene.h"

namespace raytracing {
namespace {

// What happened, to what first, and how often.
std::string text(const LoadReport::Entry& e) {
  const std::string what = e.name.empty() ? e.kind : e.kind + ": " + e.name;
  if (e.count == 1) return what;
  return what + (e.name.empty() ? fmt::format(" ({} times)", e.count)
                                : fmt::format(" (the first of {})", e.count));
}

}  // namespace

void print_load_report(const LoadReport& report, const SceneFile& scene, bool quiet, bool strict) {
  for (const LoadReport::Entry& e : report.entries()) {
    const bool told_when_quiet = e.severity != LoadReport::Severity::ignored;
    if (quiet && !told_when_quiet) continue;
    fmt::print(
        stderr, "{}\n",
        one_line(fmt::format("{}: {}: {}", to_string(e.first), to_string(e.severity), text(e))));
  }
  const std::uint64_t repaired = report.count(LoadReport::Severity::repaired);
  const std::uint64_t dropped = report.count(LoadReport::Severity::dropped);
  if (!quiet)
    fmt::print(stderr, "loaded {} files: records: {} repaired, {} dropped, {} ignored\n",
               scene.assets.size() + 1, repaired, dropped,
               report.count(LoadReport::Severity::ignored));
  if (strict && repaired + dropped > 0)
    throw InputError(fmt::format("--strict: {} records repaired, {} dropped", repaired, dropped));
}

Vec3 bring_near(SceneDescription& scene) {
  // Of half the scene's size: far above this the rounded shapes show.
  constexpr float kTolerable = 1e-4f;
  const FarPlace place = far_place(scene);
  if (place.rounding > kTolerable)
    fmt::print(stderr,
               "warning: the scene lies so far from the origin of coordinates that they "
               "are rounded to {:.1g} of its half size; store it nearer\n",
               place.rounding);
  move_scene(scene, place.origin);
  return place.origin;
}

void warn_of_narrow_pixels(const CameraDescription& camera, int height) {
  // Directions of rays, and corners as seen from their origin, are that far off at most.
  constexpr float kRounding = 0x1p-24f;
  const float pixel = 2 * std::tan(camera.vertical_fov * (kPi / 360)) / static_cast<float>(height);
  if (pixel < 8 * kRounding)
    fmt::print(stderr,
               "warning: a pixel is {:.1g} rad wide and rays are rounded to {:.1g}: shapes "
               "will be distorted; put the camera nearer\n",
               pixel, kRounding);
}

void print_scene_notes(const Scene& scene, bool quiet, bool strict) {
  const BuildNotes& notes = scene.notes();
  if (!quiet)
    fmt::print(stderr, "{} triangles, {} spheres, {} lights\n", scene.geometry().triangles().size(),
               scene.geometry().spheres().size(), scene.lights().size());
  if (scene.lights().empty())
    fmt::print(stderr, "warning: the scene has no light; the picture will be black\n");
  if (notes.averted_lights > 0)
    fmt::print(stderr,
               "warning: {} of {} lights shine away from everything: a light shines to the "
               "side from which its corners run counter-clockwise\n",
               notes.averted_lights, scene.lights().size());
  if (notes.split_lights > 0)
    fmt::print(stderr,
               "repaired: {} emitting faces are not flat and convex: each of their "
               "triangles is a light\n",
               notes.split_lights);
  if (notes.zero_area_lights > 0)
    fmt::print(stderr, "dropped: {} emitting triangles without area\n", notes.zero_area_lights);
  if (strict && notes.split_lights + notes.zero_area_lights > 0)
    throw InputError("--strict: emitting faces repaired or dropped");
}

}  // namespace raytracing
