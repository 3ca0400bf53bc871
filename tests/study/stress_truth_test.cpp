// The exact radiance of the stress cases: against quadrature and other coordinates.

#include <gtest/gtest.h>

#include "materials/ggx_reference.h"
#include "raytracing/study/stress/truth.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr LVec3 kPoint{0.1L, 0.2L, 0.0L};
constexpr DVec3 kUp{0.0, 0.0, 1.0};

LPolygon parallelogram(const LVec3& corner, const LVec3& x, const LVec3& y) {
  return {corner, corner + x, corner + x + y, corner + y};
}

double ggx(const LPolygon& light, const DVec3& wo, double alpha) {
  const LPolygon pieces[]{light};
  return ggx_radiance(pieces, kPoint, kUp, wo, alpha);
}

// Over the light's area, without any adaptivity.
double brute_force(const LPolygon& light, const DVec3& wo, double alpha, int panels) {
  const DVec3 a(light[0]), x(light[1] - light[0]), y(light[3] - light[0]);
  const DVec3 area = cross(x, y);
  return integrate2(
      [&](double s, double t) {
        const DVec3 d = a + s * x + t * y - DVec3(kPoint);
        const double r = length(d);
        const DVec3 wi = d / r;
        if (wi.z <= 0) return 0.0;
        return reference_f(alpha, wo, wi) * wi.z * std::abs(dot(area, d)) / (r * r * r);
      },
      0, 1, 0, 1, panels);
}

TEST(StressTruth, GgxAgreesWithQuadrature) {
  const LPolygon tilted =
      parallelogram({-0.9L, -0.3L, 0.5L}, {1.2L, 0.1L, 0.3L}, {-0.2L, 0.9L, 0.4L});
  for (const DVec3& wo : {normalize(DVec3(0.3, -0.2, 1)), normalize(DVec3(1, 0.2, 0.05))})
    for (const double alpha : {1.0, 0.3, 0.05}) {
      const double expected = brute_force(tilted, wo, alpha, 100);
      EXPECT_NEAR(ggx(tilted, wo, alpha) / expected, 1, 1e-7) << alpha;
    }
}

// Cut in pieces, and with an edge below the horizon.
TEST(StressTruth, GgxOfPiecesAddsUp) {
  const LPolygon wall = parallelogram({1, -1, -0.5L}, {0, 2, 0}, {0, 0, 1.5L});
  const LPolygon above = parallelogram({1, -1, 0}, {0, 2, 0}, {0, 0, 1});
  const DVec3 wo = normalize(DVec3(-1, 0.1, 0.4));
  const double whole = ggx(wall, wo, 0.2);
  EXPECT_NEAR(whole / brute_force(above, wo, 0.2, 100), 1, 1e-7);
  const LPolygon window = parallelogram({1, -0.3L, 0.2L}, {0, 0.4L, 0.1L}, {0, -0.1L, 0.3L});
  EXPECT_NEAR(
      (ggx_radiance(difference({wall}, window), kPoint, kUp, wo, 0.2) + ggx(window, wo, 0.2)) /
          whole,
      1, 1e-6);
}

// A light wide around the lobe: all that the surface reflects, an integral over half vectors whose
// coordinates resolve any roughness. The lobe's tails outside the light are of the order alpha^2.
TEST(StressTruth, GgxResolvesNarrowLobes) {
  const LPolygon light = parallelogram({-9, -9, 1}, {18, 0, 0}, {0, 18, 0});
  const DVec3 wo = normalize(DVec3(0.5, 0.2, 0.9));
  for (const double alpha : {1e-2, 1e-4, 1e-6}) {
    const double expected = integrate2(
        [&](double s, double turn) {
          const HalfVector half{s, turn};
          const DVec3 h = half.direction(alpha);
          const DVec3 wi = 2 * dot(wo, h) * h - wo;
          if (wi.z <= 0 || dot(wo, h) <= 0) return 0.0;
          return reference_f(alpha, wo, wi) * wi.z * 4 * dot(wo, h) * half.solid_angle(alpha);
        },
        0, 1, 0, 1, 40);
    const double found = ggx(light, wo, alpha);
    EXPECT_NEAR(found / expected, 1, 1e-6 + 10 * alpha * alpha) << alpha;
    // From straight above the lobe is round: an edge through its middle leaves half.
    const double all = ggx(light, kUp, alpha);
    const LPolygon half = clip(light, kPoint + LVec3(0, 0, 1), {0.6L, 0.8L, 0});
    EXPECT_NEAR(ggx(half, kUp, alpha) / all, 0.5, 1e-6 + 10 * alpha * alpha);
  }
}

// The whole chain on a scene whose penumbra is known: an occluder that hides the light's left half.
TEST(StressTruth, HalfHiddenLight) {
  StressScene stress;
  stress.scene.surfaces = {{"", Diffuse{Rgb(0.5f)}, Rgb(0.0f)}};
  PolygonMesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  mesh.corners = {{0}, {1}, {2}};
  mesh.faces = {{0, 3, 0}};
  stress.scene.meshes = {mesh};
  stress.ray = {{0, 0, 1}, {0, 0, -1}};
  stress.lights = {{{{-2, 0, 2}, {2, 0, 2}, {2, 2, 2}, {-2, 2, 2}}, 3}};
  stress.occluders = {{{-5, -5, 1}, {0, -5, 1}, {0, 5, 1}, {-5, 5, 1}}};
  const Scene scene(stress.scene, 1);
  const Vertex vertex = scene.vertex(stress.ray, scene.geometry().closest_hit(stress.ray).value());
  ASSERT_LT(length(vertex.position), 1e-6f);
  // Seen of it: 2 x 2 at the distance 2 over the corner, the form factor of a unit square at 1.
  const double factor = std::atan(1 / std::sqrt(2.0)) / std::sqrt(2.0) / std::numbers::pi;
  const StressTruth truth = exact_radiance(stress, vertex);
  EXPECT_NEAR(truth.radiance, 3 * 0.5 * factor, 1e-6);
  EXPECT_NEAR(truth.visible_share, 0.5, 1e-6);
  EXPECT_LT(truth.rounding, 1e-5);
  EXPECT_GT(truth.rounding, 0);
}

}  // namespace
}  // namespace raytracing
