// Shaft queries agree with loops over all triangles in double precision and with Embree, and no
// light leaks where surfaces meet.

#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "raytracing/geometry/occluder_tree.h"
#include "raytracing/math/vec.h"
#include "support/scenes.h"
#include "support/segment_reference.h"

namespace raytracing {
namespace {

constexpr int kNoLimit = 1 << 30;
// A ray that passes an edge within this distance may be occluded or not. The unit is the float
// spacing of the largest coordinate of the scene.
constexpr double kAllowed = 16;
constexpr int kNeedles = 300;  // number of triangles of a wall

struct Bundle {
  Vec3 p;
  std::array<float, OccluderTree::kMaxTargets> x, y, z;
  std::array<std::int32_t, OccluderTree::kMaxTargets> wanted;
  int count = 64;

  Bundle() { wanted.fill(1); }
  void set(int k, const Vec3& target) {
    x[k] = target.x;
    y[k] = target.y;
    z[k] = target.z;
  }
  Vec3 target(int k) const { return {x[k], y[k], z[k]}; }
  bool ask(const OccluderTree& tree, int limit = kNoLimit) {
    return tree.keep_visible(p, {x.data(), y.data(), z.data(), count}, wanted.data(), limit);
  }
  int left() const { return std::accumulate(wanted.begin(), wanted.begin() + count, 0); }
};

bool triangle_hides(const std::array<DVec3, 3>& c, const DVec3& p, const DVec3& x) {
  const DVec3 d = x - p, n = cross(c[1] - c[0], c[2] - c[0]);
  const double t = dot(n, c[0] - p) / dot(n, d);
  if (!(t > 0 && t < 1)) return false;
  const DVec3 q = p + t * d;
  for (std::size_t i = 0; i < 3; ++i)
    if (dot(n, cross(c[(i + 1) % 3] - c[i], q - c[i])) < 0) return false;
  return true;
}

bool hidden_by_any(const SegmentScene& scene, const DVec3& p, const DVec3& x) {
  for (std::size_t i = 0; i < scene.triangles.size(); ++i)
    if (triangle_hides(scene.corners(i), p, x)) return true;
  return std::any_of(scene.spheres.begin(), scene.spheres.end(),
                     [&](const Sphere& sphere) { return sphere_hides(sphere, p, x); });
}

SegmentScene random_scene(TestRandom& random, const Vec3& offset, float scale) {
  SegmentScene scene;
  const float size = std::exp(random.between(-4, 0.5f));
  for (std::uint64_t i = 1 + random.bits() % 60; i > 0; --i) {
    const Vec3 at = offset + random.in_cube(scale);
    scene.add(at + random.in_cube(scale * size), at + random.in_cube(scale * size),
              at + random.in_cube(scale * size));
  }
  for (std::uint64_t i = random.bits() % 3; i > 0; --i)
    scene.spheres.push_back({offset + random.in_cube(scale), scale * random.between(0.05f, 0.4f)});
  return scene;
}

/// Makes targets close together or all around, some of which are not wanted.
Bundle random_bundle(TestRandom& random, const Vec3& offset, float scale) {
  Bundle b;
  b.p = offset + random.in_cube(1.5f * scale);
  b.count = 8 * (1 + static_cast<int>(random.bits() % (random.unit() < 0.1f ? 32 : 8)));
  const Vec3 at = random.in_cube(1.5f);
  const float spread = std::exp(random.between(-7, 0.5f));
  for (int k = 0; k < b.count; ++k) {
    b.set(k, offset + scale * (at + random.in_cube(spread)));
    b.wanted[k] = random.unit() < 0.9f ? 1 : 0;
  }
  return b;
}

TEST(ShaftQuery, EqualsALoopAtEveryScaleAndFarFromTheOrigin) {
  TestRandom random(41);
  for (const auto& [scale, offset] :
       {std::pair{1.0f, 0.0f}, {1e-4f, 0.0f}, {1e5f, 0.0f}, {1.0f, 1e4f}, {1e-4f, 1e-2f}}) {
    double worst = 0;
    int seen = 0, hidden = 0;
    for (int round = 0; round < 1000; ++round) {
      const Vec3 at = offset * random.direction();
      const SegmentScene scene = random_scene(random, at, scale);
      const OccluderTree tree = scene.build();
      const Bundle before = random_bundle(random, at, scale);
      Bundle after = before;
      ASSERT_TRUE(after.ask(tree));
      for (int k = 0; k < before.count; ++k) {
        if (before.wanted[k] == 0) {
          EXPECT_EQ(after.wanted[k], 0);
          continue;
        }
        const bool is_hidden = hidden_by_any(scene, DVec3(before.p), DVec3(before.target(k)));
        ++(is_hidden ? hidden : seen);
        if (is_hidden != (after.wanted[k] == 0)) {
          const SegmentQuery ray{before.p, before.target(k), Vec3(0.0f)};
          worst = std::max(worst, clearance(scene, ray, 0) / scene.spacing(ray));
        }
      }
    }
    EXPECT_LE(worst, kAllowed) << scale << ", " << offset;
    EXPECT_GT(std::min(seen, hidden), 5000);
  }
}

TEST(ShaftQuery, EqualsEmbreeInABigScene) {
  TestRandom random(42);
  SegmentScene scene;
  for (int i = 0; i < 20; ++i)
    add_tessellated_sphere(scene, {random.in_cube(2), random.between(0.1f, 0.5f)}, 4,
                           {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}});
  const OccluderTree tree = scene.build();
  const EmbreeScene embree = scene.embree();
  int differing = 0, asked = 0, left = 0;
  for (int round = 0; round < 1000; ++round) {
    Bundle b = random_bundle(random, Vec3(0.0f), 1.5f);
    const Bundle before = b;
    ASSERT_TRUE(b.ask(tree));
    for (int k = 0; k < b.count; ++k) {
      if (before.wanted[k] == 0) continue;
      ++asked;
      left += b.wanted[k];
      differing += embree.occluded(b.p, b.target(k)) == (b.wanted[k] != 0) ? 1 : 0;
    }
  }
  EXPECT_GT(std::min(left, asked - left), 5000);
  EXPECT_LE(differing, asked / 100000);  // rays that graze an edge
}

// Rays aimed at corners and edges are occluded, although they might miss both triangles.
TEST(ShaftQuery, NothingShinesThroughClosedSurfaces) {
  TestRandom random(43);
  for (const auto& [scale, offset] :
       {std::pair{1.0f, 0.0f}, {1e-3f, 0.0f}, {1e4f, 0.0f}, {1.0f, 30.0f}}) {
    int slipped = 0;
    for (int round = 0; round < 200; ++round) {
      const Sphere sphere{offset * random.direction(), scale};
      SegmentScene scene;
      const Frame frame = Frame::around(random.direction());
      add_tessellated_sphere(scene, sphere, 3, {frame.x, frame.y, cross(frame.x, frame.y)});
      const OccluderTree tree = scene.build();
      Bundle b;
      b.p = sphere.center + 0.5f * scale * random.direction();  // inside
      for (int k = 0; k < b.count; ++k) {
        const auto& c = scene.triangles[random.bits() % scene.triangles.size()].corners;
        const float s = k % 2 == 0 ? 0 : random.unit();
        const Vec3 aim = (1 - s) * scene.positions[c[0]] + s * scene.positions[c[1]];
        b.set(k, b.p + (k % 4 < 2 ? 8.0f : 5.0f) * (aim - b.p));
      }
      ASSERT_TRUE(b.ask(tree));
      slipped += b.left();
    }
    EXPECT_EQ(slipped, 0) << scale << ", " << offset;
  }
}

// Ray origins on the walls of a closed box see each other: their own walls, on which the shafts
// begin and end, occlude nothing, although they consist of needles.
TEST(ShaftQuery, WallsDoNotHideThemselves) {
  TestRandom random(44);
  for (const auto& [scale, offset] :
       {std::pair{1.0f, 0.0f}, {1e-4f, 0.0f}, {1e5f, 0.0f}, {1.0f, 30.0f}, {1.0f, 1e3f}}) {
    int hidden = 0;
    for (int round = 0; round < 40; ++round) {
      SceneMaker maker;
      const Vec3 center = scale * offset * random.direction();
      const auto white = maker.add_surface(Diffuse{});
      const Frame turned = Frame::around(random.direction());
      const auto at = [&](const Vec3& v) { return center + scale * turned.to_world(v); };
      // The walls are fans of needles, each of which begins at its tip.
      const auto add_wall = [&](const Vec3& middle, const Vec3& u, const Vec3& v) {
        const Vec3 tip = at(middle - u - v);
        for (int i = 0; i < kNeedles; ++i) {
          const auto on_edge = [&](int n) {
            const float t = 2 * static_cast<float>(n) / kNeedles - 1;
            return at(middle + u + t * v);
          };
          const Vec3 needle[]{tip, on_edge(i), on_edge(i + 1)};
          maker.add_polygon(needle, white);
        }
        const Vec3 rest[]{tip, at(middle + u + v), at(middle - u + v)};
        maker.add_polygon(rest, white);
      };
      for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
          Vec3 n(0.0f), u(0.0f), v(0.0f);
          n[axis] = side;
          u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
          add_wall(n, u, v);
        }
      const Scene scene = maker.build();
      const auto origin_of = [&](const Vec3& direction) {
        const Ray ray{center + random.in_cube(0.3f * scale), direction};
        return scene.vertex(ray, *scene.geometry().closest_hit(ray)).ray_origin();
      };
      Bundle b;
      b.p = origin_of(random.direction());
      const Vec3 towards = random.direction();
      for (int k = 0; k < b.count; ++k)
        b.set(k, origin_of(normalize(towards + random.in_cube(0.2f))));
      ASSERT_TRUE(b.ask(scene.occluders()));
      // Rounding decides whether two points of the same wall see each other.
      for (int k = 0; k < b.count; ++k) {
        const Vec3 step = absolute(turned.to_local(b.target(k) - b.p));
        const float least = std::min(step.x, std::min(step.y, step.z));
        hidden += b.wanted[k] == 0 && least > 1e-3f * scale ? 1 : 0;
      }
    }
    EXPECT_EQ(hidden, 0) << scale << ", " << offset;
  }
}

TEST(ShaftQuery, GivesUpBeyondTheLimit) {
  SegmentScene scene;
  for (int i = 0; i < 40; ++i) {
    const auto z = static_cast<float>(1 + i);
    scene.add({-9, -9, z}, {9, -9, z}, {-9, 9, z});  // occludes the targets below a diagonal
  }
  const OccluderTree tree = scene.build();
  Bundle b;
  b.p = {0, 0, 0};
  for (int k = 0; k < b.count; ++k) b.set(k, {0.1f * static_cast<float>(k - 32), 0, 50});
  Bundle limited = b;
  EXPECT_FALSE(limited.ask(tree, 40));  // each triangle, node and block is a step
  EXPECT_TRUE(b.ask(tree, 80));
  EXPECT_LT(b.left(), 64);
  for (int k = 0; k < b.count; ++k) EXPECT_GE(limited.wanted[k], b.wanted[k]);

  scene.triangles.clear();
  scene.spheres = {{{0, 0, 9}, 1}, {{0, 0, 20}, 1}};
  Bundle past = b;
  past.wanted.fill(1);
  EXPECT_FALSE(past.ask(scene.build(), 1));
  EXPECT_TRUE(past.ask(scene.build(), 2));

  // A finely tessellated surface behind the targets costs steps too, although it occludes nothing.
  SegmentScene sheet;
  for (int i = 0; i < 3000; ++i) {
    const auto x = 0.01f * static_cast<float>(i - 1500);
    sheet.add({x, -9, 50 + x}, {x + 0.01f, -9, 50.01f + x}, {x, 9, 50 + x});
  }
  Bundle before = b;
  before.wanted.fill(1);
  for (int k = 0; k < before.count; ++k) before.z[k] = 49.99f + before.x[k];
  EXPECT_FALSE(before.ask(sheet.build(), 16));
  EXPECT_EQ(before.left(), 64);
}

TEST(ShaftQuery, WithoutATreeNothingIsTold) {
  Bundle b;
  b.p = {0, 0, 0};
  for (int k = 0; k < b.count; ++k) b.set(k, {0, 0, 1});
  EXPECT_FALSE(b.ask(OccluderTree()));
  EXPECT_EQ(b.left(), 64);
  EXPECT_TRUE(b.ask(SegmentScene().build()));
  EXPECT_EQ(b.left(), 64);
}

}  // namespace
}  // namespace raytracing
