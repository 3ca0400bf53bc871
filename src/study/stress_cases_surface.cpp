// Cases of the receiver's surface.

#include "stress_maker.h"

namespace raytracing::stress {
namespace {

constexpr std::string_view kFamily = "surface";
constexpr std::string_view kGgx = "cubature of GGX over the visible polygon";

Material ggx(float roughness) {
  return GgxConductor{Rgb(0.9f), roughness * roughness, Fresnel::none};
}

// The mirror direction meets the light close beside the shadow edge.
StressScene roughness(float r) {
  Maker maker(ggx(r));
  const Vec3 center(-0.587f, 0.443f, 1.0f);
  maker.add_light(parallelogram(center, {0.25f, 0.0f, 0.0f}, {0.0f, 0.2f, 0.0f}));
  maker.add_occluder(edge_occluder(0.5f, center, 0.5f, 0.03f));
  return maker.scene;
}

// Roughness 0.3; the light stands across, its lower half behind an occluder.
StressScene grazing_view(float cosine) {
  const Vec3 wo(std::sqrt(1 - cosine * cosine), 0.0f, cosine);
  Maker maker(ggx(0.3f), wo);
  maker.add_light(parallelogram({-1.0f, 0.05f, 0.41f}, {0.0f, 0.5f, 0.0f}, {0.0f, 0.0f, 0.4f}));
  maker.add_occluder(parallelogram({-0.5f, 0.0f, -0.3f}, {0.0f, 1.0f, 0.2f}, {0.0f, 0.0f, 0.4f}));
  return maker.scene;
}

// A triangle whose shading normal leans from its geometric one, towards a light that reaches under
// the horizon.
StressScene terminator(float degrees) {
  const float angle = degrees * 3.14159265f / 180;
  Maker maker{Maker::Empty{}};
  const std::uint32_t surface = maker.add_surface(kGrey);
  maker.add_faces({{{-0.02f, -0.02f, 0.0f}, {0.03f, -0.02f, 0.0f}, {0.01f, 0.03f, 0.0f}}}, surface);
  PolygonMesh& mesh = maker.scene.scene.meshes.back();
  mesh.normals = {{std::sin(angle), 0.0f, std::cos(angle)}};
  for (PolygonMesh::Corner& corner : mesh.corners) corner.normal = 0;
  maker.scene.ray = {kPoint + 0.01f * kView, -kView};
  maker.add_light(parallelogram({1.0f, 0.1f, 0.2f}, {0.0f, 0.5f, 0.0f}, {0.0f, 0.0f, 0.5f}));
  maker.add_light(parallelogram({-1.0f, 0.1f, 0.6f}, {0.0f, 0.5f, 0.0f}, {0.0f, 0.0f, 0.5f}));
  return maker.scene;
}

// A closed room, all of whose walls emit 1 and reflect rho.
StressScene albedo(float rho) {
  Maker maker{Maker::Empty{}};
  const std::uint32_t surface = maker.add_surface(Diffuse{Rgb(rho)}, 1);
  std::vector<Polygon> walls;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      Vec3 center(0.0f), x(0.0f), y(0.0f);
      center[axis] = side;
      x[(axis + 1) % 3] = 1;
      y[(axis + 2) % 3] = -side;
      walls.push_back(parallelogram(center, x, y));
    }
  maker.add_faces(walls, surface);
  maker.scene.ray = {Vec3(0.0f), normalize(Vec3(0.3f, -0.2f, -0.9f))};
  maker.scene.max_depth = std::nullopt;
  maker.scene.radiance = 1 / (1 - static_cast<double>(rho));
  return maker.scene;
}

}  // namespace

std::vector<StressCase> surface_cases() {
  return {
      {"roughness", kFamily, "roughness of a mirroring receiver, light's middle just lit", kGgx,
       settings({1, 0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3}, roughness)},
      {"grazing-view", kFamily, "cosine at which a GGX receiver of roughness 0.3 is seen", kGgx,
       settings({0.5, 0.1, 0.01, 1e-3, 1e-4}, grazing_view)},
      {"terminator", kFamily, "angle between geometric and shading normal, degrees",
       "Lambert's formula with the shading normal; light under either horizon is lost, by "
       "convention",
       settings({0, 10, 30, 60, 80}, terminator)},
      {"albedo", kFamily, "reflectance of a closed room that emits 1, all bounces",
       "1 / (1 - reflectance), of float32; infinite at 1, which is left out",
       settings({0, 0.25, 0.5, 0.75, 0.9, 0.97, 0.99, 0.999}, albedo)},
  };
}

}  // namespace raytracing::stress
