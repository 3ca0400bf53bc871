// Fuzzes the reader of scene files: settings are within their ranges or there is a one-line error
// with its location. The models that a scene names do not exist.

#include <cmath>

#include "fuzz.h"
#include "raytracing/io/scene_file.h"

namespace raytracing::fuzz {
namespace {

constexpr const char* kFile = "/no-such-folder/x.toml";

void check_scene(const SceneFile& file) {
  require(file.width >= 1 && file.width <= 65536 && file.height >= 1 && file.height <= 65536,
          "the picture has a size");
  require(file.spp >= 1, "there are samples");
  require(file.light_sampling == "point" || file.light_sampling == "solid-angle", "a known method");
  const CameraDescription& camera = file.scene.camera;
  require(camera.vertical_fov > 0 && camera.vertical_fov < 180, "the camera sees");
  require(camera.origin != camera.target, "the camera looks somewhere");
  for (const Surface& surface : file.scene.surfaces)
    for (int i = 0; i < 3; ++i)
      require(surface.Le[i] >= 0 && std::isfinite(surface.Le[i]), "radiance is finite and >= 0");
  for (const SphereDescription& sphere : file.scene.spheres) {
    require(sphere.radius > 0 && std::isfinite(sphere.radius), "a sphere has a radius");
    require(sphere.surface < file.scene.surfaces.size(), "a sphere has a surface");
  }
}

}  // namespace
}  // namespace raytracing::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace raytracing;
  const auto parse = [](const std::string& text, LoadReport& report) {
    fuzz::check_scene(parse_scene(text, fuzz::kFile, {"point", "solid-angle"}, report));
  };
  return fuzz::read_text(data, size, parse, [](const std::string& text, std::string_view what) {
    // The error may be about a model file; a missing table has no location.
    if (text.find("obj") != std::string::npos) {
      fuzz::check_one_line(what);
    } else {
      fuzz::check_message(what, fuzz::kFile, !what.ends_with(": 'camera' is missing"));
    }
  });
}
