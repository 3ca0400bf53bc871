#include "raytracing/io/scene_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>

#include "model_loader.h"
#include "raytracing/io/file.h"
#include "raytracing/sampling/sampler.h"
#include "raytracing/scene/description.h"
#include "toml.h"

namespace raytracing {
namespace {

const TomlKeys kRootKeys{{"camera"}, {"film", "render", "materials", "models", "spheres"}};
const TomlKeys kFilmKeys{{}, {"width", "height"}};
const TomlKeys kCameraKeys{{"origin", "target"}, {"up", "fov"}};
const TomlKeys kRenderKeys{{}, {"spp", "light_sampling"}};
const TomlKeys kMaterialKeys{{"type"}, {"reflectance", "roughness", "fresnel", "emission"}};
const TomlKeys kModelKeys{{"obj"}, {"scale", "rotate", "translate", "material"}};
const TomlKeys kSphereKeys{{"center", "radius", "material"}, {}};

// Indices into SceneDescription::surfaces by the names of materials.
using SurfaceIndices = std::map<std::string, std::uint32_t>;

void read_film(const TomlTable& film, SceneFile& file) {
  const auto size = [&](const char* key, int otherwise) {
    return static_cast<int>(film.integer(key, 1, kMaxImageSize).value_or(otherwise));
  };
  file.width = size("width", file.width);
  file.height = size("height", file.height);
}

CameraDescription read_camera(const TomlTable& table) {
  // Below this sine of the angle between up and the view, rounding decides the orientation.
  constexpr double kSmallestSine = 1e-6;
  CameraDescription camera;
  const DVec3 origin = *table.vec3("origin");
  const DVec3 target = *table.vec3("target");
  const DVec3 up = table.vec3("up").value_or(DVec3(camera.up));
  camera.origin = Vec3(origin);
  camera.target = Vec3(target);
  camera.up = Vec3(up);
  if (camera.origin == camera.target) throw table.error("target", "must differ from the origin");
  const DVec3 view = target - origin;
  if (!(length(cross(view, up)) > kSmallestSine * length(view) * length(up))) {
    throw table.error(table.has("up") ? "up" : "target",
                      "up must be neither zero nor parallel to the view from origin to target");
  }
  camera.vertical_fov = static_cast<float>(table.number("fov").value_or(camera.vertical_fov));
  if (!(camera.vertical_fov > 0 && camera.vertical_fov < 180))
    throw table.error("fov", "must be an angle in degrees between 0 and 180, both excluded");
  return camera;
}

// Far coordinates, short views and narrow angles may overflow or underflow a float in the
// computation of camera rays.
void check_camera(const CameraDescription& description, int width, int height,
                  const TomlTable& table) {
  const Camera camera(description, width, height);
  for (const Vec2& corner : {Vec2(0, 0), Vec2(width, 0), Vec2(0, height), Vec2(width, height)}) {
    const float squared =
        dot(camera.ray(corner.x, corner.y).direction, camera.ray(corner.x, corner.y).direction);
    if (!(squared > 0.99f && squared < 1.01f))
      throw table.error("target", "these numbers are too extreme to compute camera rays");
  }
}

void read_render(const TomlTable& render, const std::vector<std::string>& light_sampling_names,
                 SceneFile& file) {
  file.spp = render.integer("spp", 1, static_cast<std::int64_t>(kMaxSpp)).value_or(file.spp);
  file.light_sampling =
      render.one_of("light_sampling", light_sampling_names).value_or(file.light_sampling);
}

Rgb read_reflectance(const TomlTable& table, const Rgb& otherwise) {
  const Rgb value(table.number_or_vec3("reflectance").value_or(DVec3(otherwise)));
  for (int i = 0; i < 3; ++i)
    if (!(value[i] >= 0 && value[i] <= 1))
      throw table.error("reflectance", "each component must be in [0,1]");
  return value;
}

Diffuse read_diffuse(const TomlTable& table) {
  for (const char* key : {"roughness", "fresnel"})
    if (table.has(key)) throw table.error(key, "needs type = \"ggx\"");
  return {read_reflectance(table, Diffuse{}.reflectance)};
}

GgxConductor read_ggx(const TomlTable& table) {
  GgxConductor ggx;
  ggx.reflectance = read_reflectance(table, ggx.reflectance);
  if (const std::optional<double> roughness = table.number("roughness")) {
    ggx.alpha = static_cast<float>(*roughness * *roughness);
    if (!(*roughness > 0 && *roughness <= 1 && ggx.alpha > 0))
      throw table.error("roughness", "must be in (0,1]");
  }
  const std::string fresnel = table.one_of("fresnel", {"none", "schlick"}).value_or("none");
  ggx.fresnel = fresnel == "schlick" ? Fresnel::schlick : Fresnel::none;
  return ggx;
}

Surface read_surface(const std::string& name, const TomlTable& table) {
  Surface surface;
  surface.name = name;
  const std::string type = *table.one_of("type", {"diffuse", "ggx"});
  if (type == "ggx")
    surface.material = read_ggx(table);
  else if (type == "diffuse")
    surface.material = read_diffuse(table);
  else
    throw std::logic_error("materials of type " + type + " have no reader");
  surface.Le = Rgb(table.number_or_vec3("emission").value_or(DVec3(0.0)));
  for (int i = 0; i < 3; ++i)
    if (surface.Le[i] < 0) throw table.error("emission", "no component may be negative");
  return surface;
}

std::uint32_t find_surface(const TomlTable& table, const SurfaceIndices& surfaces) {
  const std::string name = *table.string("material");
  const auto found = surfaces.find(name);
  if (found != surfaces.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& surface : surfaces) names.push_back(surface.first);
  throw table.error("material", fmt::format("[materials.{}] is not defined", name) +
                                    (names.empty() ? ""
                                                   : fmt::format("; the nearest is [materials.{}]",
                                                                 nearest_name(name, names))));
}

ModelRequest read_model(const TomlTable& table, const std::string& scene_path,
                        const SurfaceIndices& surfaces) {
  ModelRequest request;
  const std::filesystem::path folder = std::filesystem::path(scene_path).parent_path();
  request.path = (folder / *table.string("obj")).lexically_normal().string();
  request.where = table.where("obj");
  Transform& transform = request.transform;
  transform.scale = table.number_or_vec3("scale").value_or(transform.scale);
  if (transform.scale.x == 0 || transform.scale.y == 0 || transform.scale.z == 0)
    throw table.error("scale", "no component may be zero");
  transform.rotate = table.vec3("rotate").value_or(transform.rotate);
  transform.translate = table.vec3("translate").value_or(transform.translate);
  if (table.has("material")) request.surface = find_surface(table, surfaces);
  return request;
}

SphereDescription read_sphere(const TomlTable& table, const SurfaceIndices& surfaces,
                              const SceneDescription& scene) {
  SphereDescription sphere;
  sphere.center = Vec3(*table.vec3("center"));
  sphere.radius = static_cast<float>(*table.number("radius"));
  if (!(sphere.radius > 0)) throw table.error("radius", "must be positive");
  sphere.surface = find_surface(table, surfaces);
  if (!is_black(scene.surfaces[sphere.surface].Le))
    throw table.error("material", "a sphere must not emit; lights are polygons");
  return sphere;
}

}  // namespace

SceneFile parse_scene(std::string_view text, const std::string& path,
                      const std::vector<std::string>& light_sampling_names, LoadReport& report) {
  SceneFile file;
  file.hash = hash_bytes(text);
  const TomlDocument document(text, path);
  const TomlTable root(document, document.root(), "", kRootKeys);

  if (const auto film = root.table("film", kFilmKeys)) read_film(*film, file);
  const TomlTable camera = *root.table("camera", kCameraKeys);
  file.scene.camera = read_camera(camera);
  check_camera(file.scene.camera, file.width, file.height, camera);
  if (const auto render = root.table("render", kRenderKeys))
    read_render(*render, light_sampling_names, file);
  SurfaceIndices surfaces;
  for (const auto& [name, table] : root.named_tables("materials", kMaterialKeys)) {
    surfaces.emplace(name, static_cast<std::uint32_t>(file.scene.surfaces.size()));
    file.scene.surfaces.push_back(read_surface(name, table));
  }
  for (const TomlTable& table : root.tables("spheres", kSphereKeys))
    file.scene.spheres.push_back(read_sphere(table, surfaces, file.scene));
  std::vector<ModelRequest> requests;  // the scene file's own errors come before its assets'
  for (const TomlTable& table : root.tables("models", kModelKeys))
    requests.push_back(read_model(table, path, surfaces));
  load_models(requests, file, report);
  return file;
}

SceneFile load_scene_file(const std::string& path,
                          const std::vector<std::string>& light_sampling_names,
                          LoadReport& report) {
  return parse_scene(read_file(path), path, light_sampling_names, report);
}

}  // namespace raytracing
