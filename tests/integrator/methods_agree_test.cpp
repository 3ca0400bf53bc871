// All methods of the table, with and without shared paths, at diffuse and glossy first and second
// vertices: each must give the same mean light. This is the fast test that a new method meets.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include "raytracing/render/render.h"
#include "support/scenes.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr int kSeeds = 72;
constexpr double kTolerance = 0.01;         // relative, of the whole picture
constexpr double kToleranceOfHalf = 0.015;  // of its noisier upper half
constexpr double kMaxZ = 5;                 // a normal number exceeds it once in two million

const Material kMatt = Diffuse{Rgb(0.8f)};
const Material kGlossy = GgxConductor{Rgb(0.9f), 0.3f};

struct Room {
  std::string name;
  Material floor, wall;
  bool occluded = false;
  std::uint32_t max_depth = 2;
};

const Room kMattRoom{"matt, two bounces", kMatt, kMatt, false, 3};
const Room kGlossyRoom{"glossy", kGlossy, kGlossy};
const std::vector<Room> kRooms{kMattRoom,
                               kGlossyRoom,
                               {"matt floor, glossy walls, plate", kMatt, kGlossy, true},
                               {"glossy floor, matt walls, plate", kGlossy, kMatt, true}};

/// A closed box, so that every bounce arrives at a wall; its floor, which the camera sees; a lamp
/// below its ceiling, at a distance from the walls, and a dim coloured triangle; perhaps a plate
/// that hides a part of the lamp.
SceneDescription describe(const Room& room) {
  SceneMaker maker;
  const auto floor = maker.add_surface(room.floor), wall = maker.add_surface(room.wall);
  const auto lamp = maker.add_surface(Diffuse{Rgb(0.0f)}, Rgb(3.0f));
  const auto sign = maker.add_surface(Diffuse{Rgb(0.0f)}, Rgb(0.5f, 1.0f, 2.0f));
  const Vec3 middle(0.0f);
  maker.description.meshes.push_back(inward_box(1, wall));
  maker.add_polygon(facing(parallelogram({0, 0, -0.99f}, {1, 0, 0}, {0, 1, 0}), middle), floor);
  maker.add_polygon(facing(parallelogram({0.1f, 0, 0.97f}, {0.4f, 0, 0}, {0, 0.4f, 0}), middle),
                    lamp);
  const Vec3 triangle[] = {{-0.6f, 0.5f, 0.9f}, {-0.6f, 0.1f, 0.9f}, {-0.2f, 0.5f, 0.9f}};
  maker.add_polygon(facing({triangle, triangle + 3}, middle), sign);
  if (room.occluded) {
    const auto plate = maker.add_surface(Diffuse{Rgb(0.0f)});
    maker.add_polygon(parallelogram({0.2f, 0.1f, 0.6f}, {0.3f, 0.1f, 0}, {-0.1f, 0.3f, 0}), plate);
  }
  maker.description.camera = {Vec3(-0.8f, 0, -0.2f), Vec3(0, 0, -0.99f), Vec3(0, 0, 1), 30};
  return maker.description;
}

/// Means of one small picture, by seed: of all of it, and of its upper half. Where paths are
/// shared, light that goes to the wrong pixels of a group shows in parts of the picture only.
struct Means {
  std::vector<DVec3> all, upper;
};

DVec3 mean_of_upper_half(const Film& film) {
  DVec3 sum(0.0);
  for (int y = 0; y < film.height() / 2; ++y)
    for (int x = 0; x < film.width(); ++x) sum += film.at(x, y).mean();
  return sum / (film.height() / 2.0 * film.width());
}

/// The means of a picture, by seed. The scene has an occluder tree only where the
/// options say so, as in the program.
Means means(const Room& room, const DirectMethod& method, std::uint32_t max_depth, int reuse) {
  Means result;
  RenderOptions options;
  options.width = options.height = 16;
  options.spp = 8;
  options.reuse = reuse;
  options.path = {&method, max_depth};
  const Scene scene(describe(room), 1, needs_occluders(options));
  const std::atomic<bool> stop = false;
  for (int seed = 0; seed < kSeeds; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    const Film film = render(scene, options, stop, {}).film;
    result.all.push_back(film.mean());
    result.upper.push_back(mean_of_upper_half(film));
  }
  return result;
}

/// What a picture consists of, by seed: the direct light, and the light by way of more vertices.
struct Light {
  Means direct, bounced;
};

void subtract(std::vector<DVec3>& from, const std::vector<DVec3>& less) {
  for (std::size_t i = 0; i < from.size(); ++i) from[i] -= less[i];
}

Means difference(Means from, const Means& less) {
  subtract(from.all, less.all);
  subtract(from.upper, less.upper);
  return from;
}

Light measure(const Room& room, const DirectMethod& method, int reuse) {
  const Means direct = means(room, method, 1, 1);
  return {direct, difference(means(room, method, room.max_depth, reuse), direct)};
}

/// Whether one channel of the colours, which belong together in pairs, has equal expectations.
/// Numbers that are too noisy to show a difference of the tolerance fail the test.
bool channel_agrees(std::span<const DVec3> a, std::span<const DVec3> b, int channel,
                    double relative_tolerance, const std::string& name) {
  RunningStats difference, sum;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference.add(a[i][channel] - b[i][channel]);
    sum.add(b[i][channel]);
  }
  const double distance = std::abs(difference.mean()), error = difference.standard_error();
  const double rounding = 1e-5 * sum.mean(), tolerance = relative_tolerance * sum.mean();
  if (distance > std::min(tolerance, rounding + kMaxZ * error)) {
    std::cout << name << ": " << 1 + difference.mean() / sum.mean()
              << " times the light, z = " << difference.mean() / error << "\n";
    return false;
  }
  EXPECT_LT(2 * error, tolerance) << name;
  return true;
}

bool agree(const Means& a, const Means& b, const std::string& name) {
  bool same = true;
  for (const int channel : {0, 2}) {
    same &= channel_agrees(a.all, b.all, channel, kTolerance, name);
    same &= channel_agrees(a.upper, b.upper, channel, kToleranceOfHalf, name + ", upper half");
  }
  return same;
}

/// The number of comparisons in which the methods differ from `solid-angle` without shared paths:
/// for each room the direct light, and the bounced light in both modes.
int count_disagreements(std::span<const DirectMethod> methods, const std::vector<Room>& rooms) {
  int count = 0;
  for (const Room& room : rooms) {
    const Light truth = measure(room, direct_method("solid-angle"), 1);
    for (const DirectMethod& method : methods) {
      if (room.occluded && !method.unbiased) continue;
      const std::string name = std::string(method.name) + ", " + room.name;
      const Light plain = measure(room, method, 1);
      const Means shared = difference(means(room, method, room.max_depth, 16), plain.direct);
      count += !agree(plain.direct, truth.direct, name + ", direct");
      count += !agree(plain.bounced, truth.bounced, name + ", bounced");
      count += !agree(shared, truth.bounced, name + ", bounced, shared paths");
    }
  }
  return count;
}

int count_disagreements(const DirectMethod& method, const std::vector<Room>& rooms) {
  return count_disagreements({&method, 1}, rooms);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

class MethodsAgree : public testing::Test {
 protected:
  // Sanitizers look for other faults, and find them with fewer samples in render_reuse_test.
  void SetUp() override {
    if (kSanitized) GTEST_SKIP() << "takes minutes with sanitizers";
  }
};

TEST_F(MethodsAgree, InEveryModeAtEveryMaterial) {
  EXPECT_EQ(count_disagreements(direct_methods(), kRooms), 0);
}

// Planted methods, written as one would write them.

float density(const AreaLight& light, const Vertex& from, const Vec3& q) {
  return area_pdf_w(light, from.position, q);
}

/// Adds two points of the light, each with this share and its density times `factor`.
void add_two_points(const DirectQuery& query, DirectEstimate& estimate, float share,
                    float factor = 1) {
  const Vec2 second{query.sampler.extra(query.pair, 0), query.sampler.extra(query.pair, 1)};
  for (const Vec2& u : {query.u, second}) {
    const Vec3 q = sample_area(query.light, u);
    estimate.add_point(q, factor * density(query.light, query.vertex, q), share);
  }
}

DirectMethod planted(void (*estimate)(const DirectQuery&, RayQueries&, DirectEstimate&)) {
  DirectMethod method = direct_method("point");
  method.name = "planted";
  method.estimate = estimate;
  method.pdf_w = density;
  return method;
}

TEST_F(MethodsAgree, TheAverageOfTwoPointsIsRight) {
  const DirectMethod point_2 =
      planted([](const DirectQuery& query, RayQueries&, DirectEstimate& estimate) {
        add_two_points(query, estimate, 0.5f);
      });
  EXPECT_EQ(count_disagreements(point_2, {kMattRoom, kGlossyRoom}), 0);
}

// The share that is forgotten doubles the light in every room and mode.
TEST_F(MethodsAgree, AForgottenShareIsFound) {
  const DirectMethod doubled =
      planted([](const DirectQuery& query, RayQueries&, DirectEstimate& estimate) {
        add_two_points(query, estimate, 1);
      });
  EXPECT_EQ(count_disagreements(doubled, {kMattRoom, kGlossyRoom}), 6);
}

TEST_F(MethodsAgree, AWrongDensityOfTheEstimateIsFound) {
  const DirectMethod dark =
      planted([](const DirectQuery& query, RayQueries&, DirectEstimate& estimate) {
        add_two_points(query, estimate, 0.5f, 1.03f);
      });
  EXPECT_EQ(count_disagreements(dark, {kMattRoom}), 3);
  EXPECT_GE(count_disagreements(dark, {kGlossyRoom}), 1);
}

// A density that differs from that of the estimate spoils the MIS weights of glossy surfaces only,
// by 3 % / 4 at most. With the same random numbers as `point` this is seen all the same.
TEST_F(MethodsAgree, AWrongDensityForMisIsFound) {
  const DirectMethod& point = direct_method("point");
  DirectMethod wrong = point;
  wrong.pdf_w = [](const AreaLight& light, const Vertex& from, const Vec3& q) {
    return 1.03f * density(light, from, q);
  };
  for (const int reuse : {1, 16}) {
    const Light a = measure(kGlossyRoom, wrong, reuse), b = measure(kGlossyRoom, point, reuse);
    EXPECT_FALSE(agree(a.direct, b.direct, "direct")) << reuse;
    EXPECT_FALSE(agree(a.bounced, b.bounced, "bounced")) << reuse;
  }
}

}  // namespace
}  // namespace raytracing
