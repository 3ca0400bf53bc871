#include "surface_cases.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "case_builder.h"
#include "raytracing/study/stress/truth.h"

namespace raytracing::stress {
namespace {

Material ggx(float roughness) {
  return GgxConductor{Rgb(0.9f), roughness * roughness, Fresnel::none};
}

// The mirror direction meets the light close beside the shadow edge.
StressScene roughness(float r) {
  const Vec3 center(-0.587f, 0.443f, 1.0f);
  return scene_of({.lights = {parallelogram(center, {0.25f, 0.0f, 0.0f}, {0.0f, 0.2f, 0.0f})},
                   .occluders = {edge_occluder(0.5f, center, 0.5f, 0.03f)},
                   .material = ggx(r)});
}

// Roughness 0.3; the light stands across, its lower half behind an occluder.
StressScene grazing_view(float cosine) {
  return scene_of(
      {.lights = {parallelogram({-1.0f, 0.05f, 0.41f}, {0.0f, 0.5f, 0.0f}, {0.0f, 0.0f, 0.4f})},
       .occluders = {parallelogram({-0.5f, 0.0f, -0.3f}, {0.0f, 1.0f, 0.2f}, {0.0f, 0.0f, 0.4f})},
       .material = ggx(0.3f),
       .wo = {std::sqrt(1 - cosine * cosine), 0.0f, cosine}});
}

// A triangle whose shading normal leans from its geometric one, towards a light that reaches under
// the horizon.
StressScene terminator(float degrees) {
  const float angle = degrees * 3.14159265f / 180;
  CaseBuilder builder{CaseBuilder::Empty{}};
  const std::uint32_t surface = builder.add_surface(kGrey);
  builder.add_faces({{{-0.02f, -0.02f, 0.0f}, {0.03f, -0.02f, 0.0f}, {0.01f, 0.03f, 0.0f}}},
                    surface);
  PolygonMesh& mesh = builder.scene.scene.meshes.back();
  mesh.normals = {{std::sin(angle), 0.0f, std::cos(angle)}};
  for (PolygonMesh::Corner& corner : mesh.corners) corner.normal = 0;
  builder.scene.ray = {kPoint + 0.01f * kView, -kView};
  builder.add_light(parallelogram({1.0f, 0.1f, 0.2f}, {0.0f, 0.5f, 0.0f}, {0.0f, 0.0f, 0.5f}));
  builder.add_light(parallelogram({-1.0f, 0.1f, 0.6f}, {0.0f, 0.5f, 0.0f}, {0.0f, 0.0f, 0.5f}));
  return builder.scene;
}

// A closed room, all of whose walls emit 1 and reflect rho.
StressScene albedo(float rho) {
  CaseBuilder builder{CaseBuilder::Empty{}};
  const std::uint32_t surface = builder.add_surface(Diffuse{Rgb(rho)}, 1);
  std::vector<Polygon> walls;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      Vec3 center(0.0f), x(0.0f), y(0.0f);
      center[axis] = side;
      x[(axis + 1) % 3] = 1;
      y[(axis + 2) % 3] = -side;
      walls.push_back(parallelogram(center, x, y));
    }
  builder.add_faces(walls, surface);
  builder.scene.ray = {Vec3(0.0f), normalize(Vec3(0.3f, -0.2f, -0.9f))};
  builder.scene.max_depth = std::nullopt;
  builder.scene.radiance = 1 / (1 - static_cast<double>(rho));
  return builder.scene;
}

// The receiver is lit only by the ceiling. The light shines up to that from below the horizon of
// the receiver, so that paths of one bounce carry all the radiance.
StressScene shared_paths(const Material& ceiling) {
  constexpr float kLe = 10;
  CaseBuilder builder;
  const Vec3 center(0.1f, -0.05f, 1.0f), x(2.0f, 0.0f, 0.0f), y(0.0f, 2.0f, 0.0f);
  builder.add_faces({parallelogram(center, y, x)}, builder.add_surface(ceiling));
  const Polygon light = parallelogram({0.8f, 0.1f, -0.2f}, {0.3f, 0.0f, 0.0f}, {0.0f, 0.2f, 0.0f});
  builder.add_faces({light}, builder.add_surface(Diffuse{Rgb(0.0f)}, kLe));
  const LPolygon pieces[] = {long_polygon(light)};
  const DVec3 down(0, 0, -1);
  const auto reflected = [&](const DVec3& p, const DVec3& wo) {
    return kLe * reflected_radiance(ceiling, pieces, LVec3(p), down, wo);
  };
  // The irradiance from the ceiling, times the reflectance over pi.
  const double area = 4 * length(cross(DVec3(x), DVec3(y)));
  const double irradiance =
      area * integrate_square(
                 [&](double s, double t) {
                   const DVec3 p = DVec3(center) + (2 * s - 1) * DVec3(x) + (2 * t - 1) * DVec3(y);
                   const DVec3 d = DVec3(kPoint) - p;
                   const double r2 = dot(d, d);
                   return reflected(p, d / std::sqrt(r2)) * d.z * d.z / (r2 * r2);
                 },
                 4);
  builder.scene.radiance = 0.5 / std::numbers::pi * irradiance;
  builder.scene.max_depth = 2;
  builder.scene.shares_paths = true;
  builder.scene.scene.camera = {kPoint + 0.1f * kView, kPoint, {0.0f, 1.0f, 0.0f}, 0.1f};
  return builder.scene;
}

std::vector<StressSetting> shared_path_settings() {
  std::vector<StressSetting> result{{"diffuse", [] { return shared_paths(Diffuse{Rgb(0.5f)}); }}};
  for (StressSetting& setting : settings({1, 0.7}, [](float r) { return shared_paths(ggx(r)); }))
    result.push_back(std::move(setting));
  return result;
}

}  // namespace

std::vector<StressCase> surface_cases() {
  constexpr std::string_view kGgx = "cubature of GGX over the visible polygon";
  return {
      {"roughness", "surface", "roughness of a mirroring receiver, light's middle just lit", kGgx,
       settings({1, 0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3}, roughness)},
      {"grazing-view", "surface", "cosine at which a GGX receiver of roughness 0.3 is seen", kGgx,
       settings({0.5, 0.1, 0.01, 1e-3, 1e-4}, grazing_view)},
      {"terminator", "surface", "angle between geometric and shading normal, degrees",
       "Lambert's formula with the shading normal; light under either horizon is lost, by "
       "convention",
       settings({0, 10, 30, 60, 80}, terminator)},
      {"albedo", "surface", "reflectance of a closed room that emits 1, all bounces",
       "1 / (1 - reflectance), of float32; infinite at 1, which is left out",
       settings({0, 0.25, 0.5, 0.75, 0.9, 0.97, 0.99, 0.999}, albedo)},
      {"shared-paths", "surface",
       "roughness of a ceiling that lights the receiver by shared paths of 16 x 16 pixels",
       "quadrature of the ceiling's exact radiance", shared_path_settings()},
  };
}

}  // namespace raytracing::stress
