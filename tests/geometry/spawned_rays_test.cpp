// A ray that leaves a surface does not hit it again, at any scale and position, and a shadow ray
// does not hit the light at its end.

#include <gtest/gtest.h>

#include <string>

#include "raytracing/integrator/ray_queries.h"
#include "support/scenes.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr float kScales[]{1e-4f, 1e-2f, 1, 1e2f, 1e4f, 1e6f};
constexpr float kOffsets[]{0, 1, 30, 1e3f};  // distances from the origin, in sizes of the shape

/// Returns a direction on the side of the unit normal, often close to the surface.
Vec3 leaving(const Vec3& n, TestRandom& random) {
  Vec3 d = random.direction();
  if (dot(d, n) < 0) d = -d;
  if (random.unit() < 0.5f) d = normalize(d - (1 - random.between(1e-4f, 1e-2f)) * dot(d, n) * n);
  return d;
}

/// Returns the vertex where a ray from `from` to `target` hits the only shape of the scene.
std::optional<Vertex> meet(const Scene& scene, const Vec3& from, const Vec3& target) {
  const Ray ray{from, normalize(target - from)};
  const auto hit = scene.geometry().closest_hit(ray);
  if (!hit) return std::nullopt;
  return scene.vertex(ray, *hit);
}

std::string name_of(float scale, float offset) {
  return "size " + std::to_string(scale) + ", offset " + std::to_string(offset);
}

Vec3 of_triangle(const Vec3 (&c)[3], TestRandom& random) {
  const float s = std::sqrt(random.unit()), t = random.unit();
  return (1 - s) * c[0] + s * ((1 - t) * c[1] + t * c[2]);
}

TEST(SpawnedRays, LeaveATriangle) {
  TestRandom random(21);
  for (const float scale : kScales)
    for (const float offset : kOffsets) {
      int met = 0, again = 0;
      for (int shape = 0; shape < 50; ++shape) {
        const Vec3 center = scale * offset * random.direction();
        const Vec3 c[3]{center + random.in_cube(scale), center + random.in_cube(scale),
                        center + random.in_cube(scale)};
        SceneMaker maker;
        maker.add_polygon(c, maker.add_surface(Diffuse{}));
        const Scene scene = maker.build();
        for (int i = 0; i < 100; ++i) {
          const Vec3 from = center + 3 * scale * random.direction();
          const auto v = meet(scene, from, of_triangle(c, random));
          if (!v) continue;
          ++met;
          const Ray ray{v->ray_origin(), leaving(v->ng, random)};
          again += scene.geometry().closest_hit(ray) ? 1 : 0;
        }
      }
      EXPECT_GT(met, 4500) << name_of(scale, offset);
      EXPECT_EQ(again, 0) << name_of(scale, offset);
    }
}

TEST(SpawnedRays, LeaveTheOutsideOfASphere) {
  TestRandom random(22);
  for (const float scale : kScales)
    for (const float offset : kOffsets) {
      int met = 0, again = 0;
      for (int shape = 0; shape < 20; ++shape) {
        const Vec3 center = scale * offset * random.direction();
        SceneMaker maker;
        maker.add_sphere(center, scale, maker.add_surface(Diffuse{}));
        const Scene scene = maker.build();
        for (int i = 0; i < 250; ++i) {
          const Vec3 from = center + 3 * scale * random.direction();
          const auto v = meet(scene, from, center + random.in_cube(0.57f * scale));
          if (!v) continue;
          ++met;
          const Ray ray{v->ray_origin(), leaving(v->ng, random)};
          again += scene.geometry().closest_hit(ray) ? 1 : 0;
        }
      }
      EXPECT_EQ(met, 5000) << name_of(scale, offset);
      EXPECT_EQ(again, 0) << name_of(scale, offset);
    }
}

// Inside a sphere a ray hits the other side after a chord of 2 r cos, not its own origin.
TEST(SpawnedRays, CrossTheInsideOfASphere) {
  TestRandom random(23);
  for (const float scale : kScales)
    for (const float offset : kOffsets) {
      int wrong = 0;
      for (int shape = 0; shape < 20; ++shape) {
        const Vec3 center = scale * offset * random.direction();
        SceneMaker maker;
        maker.add_sphere(center, scale, maker.add_surface(Diffuse{}));
        const Scene scene = maker.build();
        for (int i = 0; i < 250; ++i) {
          const auto v = meet(scene, center, center + scale * random.direction());
          ASSERT_TRUE(v);
          Vec3 d = random.direction();
          if (dot(d, v->ng) < 0) d = -d;
          const float cosine = dot(d, v->ng);
          if (cosine < 0.2f) continue;
          const auto hit = scene.geometry().closest_hit({v->ray_origin(), d});
          if (!hit || std::abs(hit->t / (2 * scale * cosine) - 1) > 0.1f) ++wrong;
        }
      }
      EXPECT_EQ(wrong, 0) << name_of(scale, offset);
    }
}

// A shadow ray ends in front of the light at any grazing angle.
TEST(SpawnedRays, EndBeforeTheLight) {
  TestRandom random(24);
  for (const float scale : kScales)
    for (const float offset : kOffsets) {
      int blocked = 0;
      for (int shape = 0; shape < 50; ++shape) {
        const Vec3 center = scale * offset * random.direction();
        const Vec3 c[3]{center + random.in_cube(scale), center + random.in_cube(scale),
                        center + random.in_cube(scale)};
        SceneMaker maker;
        maker.add_polygon(c, maker.add_surface(Diffuse{}, Rgb(1.0f)));
        const Scene scene = maker.build();
        const AreaLight& light = scene.lights()[0];
        for (int i = 0; i < 100; ++i) {
          Vec3 from = center + 3 * scale * random.direction();
          const float height = dot(from - c[0], light.normal);
          if (height < 2 * light.error) from += (2 * light.error - 2 * height) * light.normal;
          const Vec3 end =
              offset_point(sample_area(light, random.unit2()), light.normal, light.error);
          blocked += scene.geometry().occluded(from, end) ? 1 : 0;
        }
      }
      EXPECT_EQ(blocked, 0) << name_of(scale, offset);
    }
}

// The light is near the origin of coordinates and its plane is thus accurate; the vertex is far
// away and sees it at a grazing angle.
TEST(SpawnedRays, EndBeforeTheLightOfAFarVertex) {
  TestRandom random(25);
  for (const float scale : kScales)
    for (const float distance : {10.0f, 1e3f, 1e5f}) {
      int met = 0, blocked = 0;
      for (int shape = 0; shape < 100; ++shape) {
        const Vec3 n = random.direction();
        const Frame frame = Frame::around(n);
        const float flat = random.between(1e-3f, 0.1f);
        const Vec3 far = scale * distance * (frame.x + flat * n);
        SceneMaker maker;
        maker.add_polygon(parallelogram(Vec3(0.0f), scale * frame.x, scale * frame.y),
                          maker.add_surface(Diffuse{}, Rgb(1.0f)));
        maker.add_polygon(parallelogram(far, scale * frame.y, scale * n),
                          maker.add_surface(Diffuse{}));
        const Scene scene = maker.build();
        RayQueries visibility(scene);
        for (int i = 0; i < 50; ++i) {
          const Vec3 target = far + scale * (random.unit() * frame.y + random.unit() * n);
          const auto v = meet(scene, target - 2 * scale * frame.x + scale * n, target);
          if (!v) continue;
          ++met;
          const AreaLight& light = scene.lights()[0];
          blocked += visibility.occluded(*v, sample_area(light, random.unit2()), light) ? 1 : 0;
        }
      }
      EXPECT_GT(met, 2500) << name_of(scale, distance);
      EXPECT_EQ(blocked, 0) << name_of(scale, distance);
    }
}

}  // namespace
}  // namespace raytracing
