// What layers are told about single hits, against closed forms.

#include "raytracing/integrator/first_hit.h"

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace raytracing {
namespace {

/// What the ray from `origin` to `target` meets.
FirstHit first_hit(const Scene& scene, const Vec3& origin, const Vec3& target) {
  const Ray ray{origin, normalize(target - origin)};
  return describe_first_hit(scene, scene.vertex(ray, scene.geometry().closest_hit(ray).value()),
                            ray);
}

/// A square in the plane z = 0 with its normal to +z, seen from (0.3, 0.4, `side`).
FirstHit hit_of_square(const Material& material, const Rgb& Le, float side = 1) {
  SceneMaker maker;
  maker.add_polygon(parallelogram(Vec3(0.0f), {1, 0, 0}, {0, 1, 0}),
                    maker.add_surface(material, Le));
  return first_hit(maker.build(), {0.3f, 0.4f, side}, {0.3f, 0.4f, 0});
}

TEST(FirstHit, AlbedoIsTheReflectance) {
  const Rgb rho(0.1f, 0.5f, 1);
  EXPECT_EQ(hit_of_square(Diffuse{rho}, Rgb(0.0f)).albedo, rho);
  EXPECT_EQ(hit_of_square(Diffuse{Rgb(0.0f)}, Rgb(0.0f)).albedo, Rgb(0.0f));
  for (const Fresnel fresnel : {Fresnel::none, Fresnel::schlick})
    for (const float alpha : {0.01f, 1.0f})
      EXPECT_EQ(hit_of_square(GgxConductor{rho, alpha, fresnel}, Rgb(0.0f)).albedo, rho)
          << "at normal incidence, whatever the roughness";
}

TEST(FirstHit, AlbedoIsOneWhereALightShinesOnTheViewer) {
  const Rgb rho(0.1f, 0.5f, 1), dim(0, 1e-3f, 0);
  EXPECT_EQ(hit_of_square(Diffuse{rho}, dim).albedo, Rgb(1.0f));
  EXPECT_EQ(hit_of_square(Diffuse{rho}, dim, -1).albedo, rho) << "its back does not shine";
}

TEST(FirstHit, NormalIsOnTheSideOfTheViewer) {
  EXPECT_EQ(hit_of_square(Diffuse{}, Rgb(0.0f)).normal, Vec3(0, 0, 1));
  EXPECT_EQ(hit_of_square(Diffuse{}, Rgb(0.0f), -1).normal, Vec3(0, 0, -1));
}

TEST(FirstHit, NormalIsTheInterpolatedOne) {
  SceneMaker maker;
  const auto surface = maker.add_surface(Diffuse{});
  const auto corners = parallelogram(Vec3(0.0f), {1, 0, 0}, {0, 1, 0});
  maker.add_polygon(corners, surface);
  PolygonMesh& mesh = maker.description.meshes[0];
  mesh.normals = {Vec3(0.6f, 0, 0.8f)};
  for (PolygonMesh::Corner& corner : mesh.corners) corner.normal = 0;
  const Vec3 target(0.1f, 0.2f, 0);
  const Vec3 front = first_hit(maker.build(), {0, 0, 3}, target).normal;
  EXPECT_LT(length(front - mesh.normals[0]), 1e-6f);
  EXPECT_LT(length(first_hit(maker.build(), {0, 0, -3}, target).normal + mesh.normals[0]), 1e-6f);
}

TEST(FirstHit, DistanceAndPositionOfASphere) {
  SceneMaker maker;
  maker.add_sphere({1, 2, 3}, 0.5f, maker.add_surface(Diffuse{}));
  const FirstHit hit = first_hit(maker.build(), {1, 2, 10}, {1, 2, 3});
  EXPECT_NEAR(hit.distance, 6.5, 1e-5);
  EXPECT_LT(length(hit.position - DVec3(1, 2, 3.5)), 1e-5);
  EXPECT_LT(length(hit.normal - Vec3(0, 0, 1)), 1e-6f);
}

// The distance is that of the scene as it was moved, where floats are fine.
TEST(FirstHit, PositionIsThatOfTheFileWhereTheSceneWasMoved) {
  const Vec3 place(1e6f, -2e6f, 3e6f);
  SceneMaker maker;
  maker.add_polygon(parallelogram(place, {1, 0, 0}, {0, 1, 0}), maker.add_surface(Diffuse{}));
  recenter(maker.description, place);
  const Scene scene = maker.build();
  const FirstHit hit = first_hit(scene, {0.25f, 0.125f, 2}, {0.25f, 0.125f, 0});
  EXPECT_LT(length(hit.position - (DVec3(place) + DVec3(0.25, 0.125, 0))), 1e-6);
  EXPECT_NEAR(hit.distance, 2, 1e-6);
}

}  // namespace
}  // namespace raytracing
