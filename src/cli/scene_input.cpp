#include "scene_input.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/io/errors.h"
#include "raytracing/math/numeric.h"
#include "raytracing/scene/description.h"
#include "terminal.h"

namespace raytracing {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

bool path_exists(const fs::path& path) {
  std::error_code error;  // a name that is too long does not exist either
  return fs::exists(path, error);
}

// Returns the folder of the scenes that come with the program; empty if /proc is not mounted.
fs::path scene_folder() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (error) return {};
  const bool is_build_tree = path_exists(folder / "CMakeCache.txt");
  return folder.parent_path() / (is_build_tree ? "scenes" : "share/raytracing/scenes");
}

// Says what happened, to what first, and how often.
std::string to_text(const LoadReport::Entry& e) {
  std::string what = e.name.empty() ? e.kind : e.kind + ": " + e.name;
  if (e.count == 1) return what;
  if (e.name.empty()) return fmt::format("{} ({} times)", what, e.count);
  return fmt::format("{} (the first of {})", what, e.count);
}

// Moves a scene that lies far from the origin of coordinates there.
void move_to_origin(SceneDescription& scene) {
  // Relative to half the scene's size; rounding far above this is visible in the shapes.
  constexpr float kTolerableRounding = 1e-4f;
  const Recentering place = find_recentering(scene);
  if (place.rounding > kTolerableRounding)
    print_message(
        "warning: the scene lies so far from the origin that its coordinates are rounded to "
        "{:.1g} of half its size; move it closer to the origin\n",
        place.rounding);
  recenter(scene, place.origin);
}

// Warns if pixels are so narrow that the rounding of ray directions is visible. This begins at
// distances of some 1e4 times the size of what the camera sees.
void warn_of_narrow_pixels(const CameraDescription& camera, int height) {
  // An upper bound for ray directions and for vertices seen from the ray's origin.
  constexpr float kRounding = 0x1p-24f;
  const float pixel = 2 * std::tan(camera.vertical_fov * (kPi / 360)) / static_cast<float>(height);
  if (pixel < 8 * kRounding)
    print_message(
        "warning: a pixel is {:.1g} rad wide and ray directions are rounded to {:.1g}: "
        "shapes will be distorted; move the camera closer\n",
        pixel, kRounding);
}

}  // namespace

std::vector<std::string> scene_candidates(const std::string& name) {
  std::vector<std::string> candidates{name};
  if (name.find('/') != std::string::npos) return candidates;
  const std::string file = name.ends_with(".toml") ? name : name + ".toml";
  if (file != name) candidates.push_back(file);
  const fs::path folder = scene_folder();
  if (!folder.empty()) candidates.push_back(folder / file);
  return candidates;
}

std::optional<std::string> find_scene(const std::string& name) {
  for (const std::string& candidate : scene_candidates(name))
    if (path_exists(candidate)) return candidate;
  return std::nullopt;
}

SceneInput::SceneInput(const std::string& path, bool quiet, bool strict)
    : quiet_(quiet), strict_(strict) {
  const Clock::time_point start = Clock::now();
  LoadReport report;
  file_ = load_scene_file(path, direct_method_names(), report);
  load_seconds_ = seconds_since(start);
  report_loading(path, report);
}

const Scene& SceneInput::build(int image_height, int threads, bool with_occluders) {
  const Clock::time_point start = Clock::now();
  move_to_origin(file_.scene);
  warn_of_narrow_pixels(file_.scene.camera, image_height);
  scene_.emplace(std::move(file_.scene), threads, with_occluders);
  build_seconds_ = seconds_since(start);
  report_building();
  return *scene_;
}

void SceneInput::report_loading(const std::string& path, const LoadReport& report) const {
  for (const LoadReport::Entry& e : report.entries()) {
    if (quiet_ && e.severity == LoadReport::Severity::ignored) continue;
    print_message("{}\n", one_line(fmt::format("{}: {}: {}", to_string(e.first),
                                               to_string(e.severity), to_text(e))));
  }
  const std::uint64_t repaired = report.count(LoadReport::Severity::repaired);
  const std::uint64_t dropped = report.count(LoadReport::Severity::dropped);
  if (!quiet_)
    print_message("{}: {} read; records repaired: {}, dropped: {}, ignored: {}\n", one_line(path),
                  counted(file_.assets.size() + 1, "file"), repaired, dropped,
                  report.count(LoadReport::Severity::ignored));
  if (strict_ && repaired + dropped > 0)
    throw InputError(fmt::format("--strict: records repaired: {}, dropped: {}", repaired, dropped));
}

void SceneInput::report_building() const {
  const BuildNotes& notes = scene_->notes();
  const std::size_t lights = scene_->lights().size();
  if (!quiet_)
    print_message("{}, {}, {}\n", counted(scene_->geometry().triangles().size(), "triangle"),
                  counted(scene_->geometry().spheres().size(), "sphere"), counted(lights, "light"));
  if (lights == 0) print_message("warning: the scene has no light; the image will be black\n");
  if (notes.lights_facing_nothing > 0)
    print_message(
        "warning: lights that face away from everything: {} of {}; a light emits to the "
        "side from which its vertices appear counter-clockwise\n",
        notes.lights_facing_nothing, lights);
  if (notes.split_lights > 0)
    print_message(
        "repaired: emitting faces that are not flat and convex: {}; each of their triangles "
        "becomes a light\n",
        notes.split_lights);
  if (notes.zero_area_lights > 0)
    print_message("dropped: emitting triangles without area: {}\n", notes.zero_area_lights);
  if (strict_ && notes.split_lights + notes.zero_area_lights > 0)
    throw InputError("--strict: emitting faces were repaired or dropped");
}

}  // namespace raytracing
