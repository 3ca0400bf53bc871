#include "raytracing/geometry/embree_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "raytracing/io/file.h"
#include "raytracing/io/obj.h"
#include "support/scenes.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A right triangle in the plane z = 2, and spheres in front of and behind it.
EmbreeScene triangle_and_spheres() {
  return EmbreeScene({{0, 0, 2}, {4, 0, 2}, {0, 4, 2}}, {{{0, 1, 2}}},
                     {{{1, 1, 5}, 1}, {{8, 8, 0}, 2}, {{1, 1, -3}, 0.5f}}, 1);
}

TEST(EmbreeScene, HitsTriangleWithDistanceAndBarycentricWeights) {
  const EmbreeScene scene = triangle_and_spheres();
  const auto hit = scene.closest_hit({{2, 1, 0}, {0, 0, 1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->kind, Hit::Kind::triangle);
  EXPECT_EQ(hit->index, 0u);
  EXPECT_FLOAT_EQ(hit->t, 2);
  EXPECT_FLOAT_EQ(hit->u, 0.5f);
  EXPECT_FLOAT_EQ(hit->v, 0.25f);
  // The ray comes from behind, and its direction is not of unit length.
  const auto back = scene.closest_hit({{2, 1, 3}, {0, 0, -0.5f}});
  ASSERT_TRUE(back);
  EXPECT_FLOAT_EQ(back->t, 2);
  EXPECT_FLOAT_EQ(back->u, 0.5f);
  EXPECT_FALSE(scene.closest_hit({{2.1f, 2, 0}, {0, 0, 1}}));
  EXPECT_FALSE(scene.closest_hit({{2, 1, 0}, {0, 0, -1}}));
}

TEST(EmbreeScene, HitsTheNearerCrossingOfASphereThatLiesAhead) {
  const EmbreeScene scene = triangle_and_spheres();
  const auto hit = scene.closest_hit({{8, 8, -10}, {0, 0, 2}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->kind, Hit::Kind::sphere);
  EXPECT_EQ(hit->index, 1u);
  EXPECT_EQ(hit->t, 4);
  const auto inside = scene.closest_hit({{8, 8, 0}, {0, 1, 0}});
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->t, 2);
  EXPECT_FALSE(scene.closest_hit({{8, 8, 2.5f}, {0, 0, 1}}));
}

TEST(EmbreeScene, ReportsTheNearestOfTrianglesAndSpheres) {
  const EmbreeScene scene = triangle_and_spheres();
  const struct {
    float z, direction;
    Hit::Kind kind;
    std::uint32_t index;
    float t;
  } rays[]{{0, 1, Hit::Kind::triangle, 0, 2},   {3, 1, Hit::Kind::sphere, 0, 1},
           {9, -1, Hit::Kind::sphere, 0, 3},    {3, -1, Hit::Kind::triangle, 0, 1},
           {-9, 1, Hit::Kind::sphere, 2, 5.5f}, {5, -1, Hit::Kind::sphere, 0, 1}};
  for (const auto& ray : rays) {
    const auto hit = scene.closest_hit({{1, 1, ray.z}, {0, 0, ray.direction}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->kind, ray.kind);
    EXPECT_EQ(hit->index, ray.index);
    EXPECT_FLOAT_EQ(hit->t, ray.t);
  }
}

TEST(EmbreeScene, PacketsHitWhatSingleRaysHit) {
  const EmbreeScene scene = triangle_and_spheres();
  TestRandom random(31);
  int met = 0;
  for (int round = 0; round < 1000; ++round) {
    std::array<Ray, 8> rays;
    std::array<std::optional<Hit>, 8> hits;
    const std::size_t n = 1 + random.bits() % 8;
    const Vec3 from = random.in_cube(10), towards = random.in_cube(4);
    for (std::size_t k = 0; k < n; ++k) rays[k] = {from, towards + random.in_cube(1) - from};
    scene.closest_hits8(std::span(rays).first(n), hits.data());
    for (std::size_t k = 0; k < n; ++k) {
      const auto single = scene.closest_hit(rays[k]);
      ASSERT_EQ(hits[k].has_value(), single.has_value());
      if (!single) continue;
      ++met;
      EXPECT_EQ(hits[k]->kind, single->kind);
      EXPECT_EQ(hits[k]->index, single->index);
      EXPECT_NEAR(hits[k]->t, single->t, 1e-5f * single->t);
      if (single->kind == Hit::Kind::sphere) continue;
      EXPECT_NEAR(hits[k]->u, single->u, 1e-4f);
      EXPECT_NEAR(hits[k]->v, single->v, 1e-4f);
    }
    for (std::size_t k = n; k < 8; ++k) EXPECT_FALSE(hits[k]);
  }
  EXPECT_GT(met, 400);
}

TEST(EmbreeScene, OccludedLooksBetweenThePointsOnly) {
  const EmbreeScene scene = triangle_and_spheres();
  const auto occluded = [&](float z0, float z1) { return scene.occluded({1, 1, z0}, {1, 1, z1}); };
  EXPECT_TRUE(occluded(1, 3));
  EXPECT_TRUE(occluded(3, 1));
  EXPECT_TRUE(occluded(1.999f, 2.001f));
  EXPECT_FALSE(occluded(0, 1.999f));       // in front of the triangle
  EXPECT_FALSE(occluded(2.001f, 3.999f));  // between triangle and sphere
  EXPECT_TRUE(occluded(3, 5));             // ends inside the sphere
  EXPECT_TRUE(occluded(5, 7));             // starts inside the sphere
  EXPECT_FALSE(occluded(4.5f, 5.5f));      // both ends inside the sphere
  EXPECT_FALSE(occluded(6.001f, 100));     // behind everything
  EXPECT_FALSE(occluded(1, 1));
}

TEST(EmbreeScene, EmptySceneIsHitByNothing) {
  const EmbreeScene scene({}, {}, {}, 1);
  EXPECT_FALSE(scene.closest_hit({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_FALSE(scene.occluded({0, 0, 0}, {0, 0, 1}));
  EXPECT_TRUE(scene.positions().empty());
}

TEST(EmbreeScene, NonFiniteTriangleIsNotHit) {
  const EmbreeScene scene({{0, 0, 2}, {kInfinity, 0, 2}, {0, 4, 2}, {4, 0, 3}},
                          {{{0, 1, 2}}, {{0, 3, 2}}}, {}, 1);
  const auto hit = scene.closest_hit({{1, 1, 0}, {0, 0, 1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->index, 1u);
}

// The following tests show that a closed mesh is closed.

struct ClosedMesh {
  std::vector<Vec3> positions;
  std::vector<EmbreeScene::Triangle> triangles;
  EmbreeScene build() const { return EmbreeScene(positions, triangles, {}, 1); }
};

/// Loads models/sphere.obj, which has 20,480 triangles on the unit sphere.
ClosedMesh sphere_model() {
  LoadReport report;
  const std::string path = RAYTRACING_SOURCE_DIR "/models/sphere.obj";
  const PolygonMesh mesh = parse_obj(read_file(path), path, report).mesh;
  ClosedMesh closed{mesh.positions, {}};
  for (const PolygonMesh::Face& face : mesh.faces) {
    const PolygonMesh::Corner* c = &mesh.corners[face.first_corner];
    EXPECT_EQ(face.corner_count, 3u);
    closed.triangles.push_back({{c[0].position, c[1].position, c[2].position}});
  }
  EXPECT_EQ(closed.triangles.size(), 20'480u);
  return closed;
}

/// Returns whether a ray from inside hits the mesh and a segment that ends outside is occluded.
bool is_stopped(const EmbreeScene& scene, const Vec3& from, const Vec3& towards) {
  return scene.closest_hit({from, towards - from}).has_value() &&
         scene.occluded(from, from + 4.0f * (towards - from));
}

Vec3 within(TestRandom& random) { return random.in_cube(0.5f); }

TEST(ClosedMesh, NoRayEscapesInAnyDirection) {
  const EmbreeScene scene = sphere_model().build();
  TestRandom random(11);
  int escaped = 0;
  for (int i = 0; i < 2'000'000; ++i) {
    const Vec3 from = within(random);
    escaped += is_stopped(scene, from, from + 2.0f * random.direction()) ? 0 : 1;
  }
  EXPECT_EQ(escaped, 0);
}

// Embree's robust mode closes edges, but a ray aimed exactly at a vertex may pass between all of
// its triangles. About 1 % of such rays do; without robust mode 25 % would. Rays of an image are
// never aimed so.
TEST(ClosedMesh, FewRaysEscapeThroughAVertex) {
  const ClosedMesh mesh = sphere_model();
  const EmbreeScene scene = mesh.build();
  TestRandom random(12);
  int escaped = 0;
  for (int i = 0; i < 40; ++i)
    for (const Vec3& vertex : mesh.positions)
      escaped += is_stopped(scene, i == 0 ? Vec3(0.0f) : within(random), vertex) ? 0 : 1;
  EXPECT_LT(escaped, 0.02 * 40 * static_cast<double>(mesh.positions.size()));
}

TEST(ClosedMesh, NoRayEscapesThroughAnEdge) {
  const ClosedMesh mesh = sphere_model();
  const EmbreeScene scene = mesh.build();
  TestRandom random(13);
  int escaped = 0;
  for (int i = 0; i < 10; ++i)
    for (const EmbreeScene::Triangle& t : mesh.triangles)
      for (int c = 0; c < 3; ++c) {
        const Vec3 a = mesh.positions[t.corners[c]], b = mesh.positions[t.corners[(c + 1) % 3]];
        const Vec3 on_edge = a + (i == 0 ? 0.5f : random.unit()) * (b - a);
        escaped += is_stopped(scene, i == 0 ? Vec3(0.0f) : within(random), on_edge) ? 0 : 1;
      }
  EXPECT_EQ(escaped, 0);
}

}  // namespace
}  // namespace raytracing
