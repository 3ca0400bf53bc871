#include "raytracing/study/stress/cases.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "case_builder.h"
#include "surface_cases.h"

namespace raytracing {
namespace stress {
namespace {

// Cases of the light's shape and position.

StressScene aspect(float ratio) {
  return scene_of(
      {.lights = {parallelogram(kCenter, {0.5f, 0.0f, 0.0f}, {0.0f, 0.5f / ratio, 0.0f})},
       .occluders = {edge_occluder()}});
}

// The light keeps its size; the occluder stays half way, its shadow edge above the receiver, where
// a near light is brightest.
StressScene distance(float d) {
  const float near = std::min(d, 1.0f);
  const Vec3 target = kPoint + Vec3(0.1f * near, 0.05f * near, d);
  return scene_of(
      {.lights = {parallelogram({0.113f, 0.043f, d}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.35f, 0.0f})},
       .occluders = {edge_occluder(d / 2, target, 0.5f, 0.01f * near, 0.5f)},
       .eye = std::min(0.01f, 0.2f * d)});
}

// A wall of light across the x axis, seen over the receiver from its side.
StressScene wall(const Vec3& center, float half_height = 0.5f) {
  return scene_of({.lights = {parallelogram(center, {0.0f, 0.5f, 0.0f}, {0.0f, 0.0f, half_height})},
                   .wo = {-0.48f, -0.36f, 0.8f}});
}

// A wall in the plane x = g from the receiver, beside it.
StressScene grazing(float g) { return wall(kPoint + Vec3(g, 1.0f, 0.6f), 0.4f); }

// A wall that reaches `above` over the horizon, and the rest of its height of 1 below.
StressScene horizon(float above) { return wall(Vec3(1.0f, 0.1f, above - 0.5f)); }

// A wall that stands on the receiver's plane, one corner at the distance d.
StressScene corner(float d) { return wall(kPoint + Vec3(d, 0.5f, 0.5f)); }

// Cases of the shape, the place or the mesh of an occluder.

StressScene contact(float gap) {
  const Vec3 center = 1.5f * kCenter;
  return scene_of({.lights = {parallelogram(center, {0.5f, 0.0f, 0.0f}, {0.0f, 0.35f, 0.0f})},
                   .occluders = {edge_occluder(gap, center, 0.5f, 0.02f * gap, 0.5f)},
                   .eye = std::min(0.01f, 0.2f * gap)});
}

StressScene edge_direction(float degrees) {
  return scene_of({.lights = {ceiling_light()},
                   .occluders = {edge_occluder(0.5f, kCenter, degrees * 3.14159265f / 180)}});
}

// Slats and slits of equal width alternate over a width of 2, oblique to the light.
StressScene blinds(float count) {
  Setup setup{.lights = {ceiling_light()}};
  const Vec3 along(std::cos(0.3f), std::sin(0.3f), 0.0f), across(-along.y, along.x, 0.0f);
  const int n = static_cast<int>(count);
  const float pitch = 2 / count;
  for (int i = 0; i < n; ++i) {
    const float at = (static_cast<float>(i) + 0.5f) * pitch - 1;
    setup.occluders.push_back(parallelogram(Vec3(0.06f, 0.02f, 0.5f) + (at + 0.3f * pitch) * across,
                                            along, 0.25f * pitch * across));
  }
  return scene_of(setup);
}

// The standard occluder as triangles with one corner in common, along whose other sides the shadow
// edge runs.
StressScene needles(float count) {
  CaseBuilder builder({.lights = {ceiling_light()}});
  const Polygon square = edge_occluder();
  const int n = static_cast<int>(count);
  std::vector<Polygon> faces{{square[3], square[1], square[2]}};
  Vec3 last = square[0];
  for (int i = 1; i <= n; ++i) {
    const float t = static_cast<float>(i) / count;
    const Vec3 next = i == n ? square[1] : (1 - t) * square[0] + t * square[1];
    faces.push_back({square[3], last, next});
    last = next;
  }
  builder.add_occluder(faces, square);
  return builder.scene;
}

// The standard occluder, tilted, as a grid of triangles whose inner corners are moved about.
StressScene tessellation(float count) {
  CaseBuilder builder({.lights = {ceiling_light()}});
  Polygon square = edge_occluder(0.5f, kCenter, 0.5f, 0.01f, 0.4f);
  for (std::size_t i = 2; i < 4; ++i) square[i].z += 0.2f;
  const int n = static_cast<int>(std::lround(std::sqrt(count / 2)));
  std::mt19937 random(7);
  const auto jitter = [&](int i) {
    const double shift = i == 0 || i == n ? 0.0 : static_cast<double>(random()) * 0x1p-32 - 0.5;
    return static_cast<float>((i + 0.5 * shift) / n);
  };
  std::vector<Vec3> points;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const float s = jitter(x), t = jitter(y);
      points.push_back(square[0] + s * (square[1] - square[0]) + t * (square[3] - square[0]));
    }
  std::vector<Polygon> faces;
  const auto at = [&](int x, int y) { return points[static_cast<std::size_t>(y * (n + 1) + x)]; };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  builder.add_occluder(faces, square);
  return builder.scene;
}

// Adds the faults of real meshes: at level 1 every face twice, at 2 overlapping faces in one plane,
// at 3 faces without area, at 4 all of these and each face a hundred times.
StressScene degenerate(float level) {
  const auto is = [level](float l) { return level == l || level == 4; };
  const Polygon square = edge_occluder();
  CaseBuilder builder({.lights = {ceiling_light()}, .occluders = {square}});
  const Vec3 middle = 0.25f * (square[0] + square[1] + square[2] + square[3]);
  if (is(1))
    for (int i = 0; i < (level == 4 ? 100 : 1); ++i) builder.add_black_faces({square});
  if (is(2)) {
    const Polygon half{square[0], square[1], middle};
    builder.add_black_faces({half, {half[1], half[0], half[2]}, {square[0], middle, square[3]}});
  }
  if (is(3)) {
    const Vec3 on_edge = 0.5f * (square[0] + square[1]);
    builder.add_black_faces({{square[0], square[1], on_edge},
                             {middle, middle, square[0]},
                             {middle, middle, middle},
                             {kCenter, kCenter, kCenter},
                             {kPoint, kPoint, kCenter}});
    builder.add_faces({{kCenter, kCenter, kPoint}}, builder.add_surface(kGrey, 1));
  }
  return builder.scene;
}

std::vector<StressSetting> degenerate_settings() {
  std::vector<StressSetting> result = settings({0, 1, 2, 3, 4}, degenerate);
  const char* labels[] = {"clean", "twice", "coplanar", "no-area", "all"};
  for (std::size_t i = 0; i < result.size(); ++i) result[i].label = labels[i];
  return result;
}

// Cases of the scene's numbers: scale, offset, many lights.

StressScene penumbra(float eye = 0.01f, float half = 0.02f) {
  return scene_of(
      {.lights = {ceiling_light()}, .occluders = {edge_occluder()}, .eye = eye, .half = half});
}

StressScene scaled(float s) { return transformed(penumbra(), s, Vec3(0.0f)); }

// The rounded coordinates are the scene. The receiver is large enough for some of it to remain.
StressScene offset(float o) {
  return transformed(penumbra(0.3f, 0.5f), 1, Vec3(o, -0.7f * o, 0.4f * o));
}

// The bright light is hidden, but lights are chosen by their power.
StressScene bright_pair(float ratio) {
  CaseBuilder builder;
  const Vec3 x(0.15f, 0.0f, 0.0f), y(0.0f, 0.15f, 0.0f);
  builder.add_light(parallelogram({-0.6f, 0.0f, 1.0f}, x, y), ratio);
  builder.add_light(parallelogram({0.6f, 0.0f, 1.0f}, x, y));
  builder.add_occluder(parallelogram({-0.3f, 0.0f, 0.5f}, {0.2f, 0.0f, 0.0f}, {0.0f, 0.3f, 0.0f}));
  return builder.scene;
}

// A square of 2 x 2 above the receiver, a quarter of which is luminous.
StressScene many_lights(float count) {
  Setup setup{.lights = {}, .occluders = {edge_occluder()}};
  const int n = static_cast<int>(count);
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const float pitch = 2 / static_cast<float>(columns);
  const auto place = [pitch](int i) { return (static_cast<float>(i) + 0.5f) * pitch - 1; };
  for (int i = 0; i < n; ++i)
    setup.lights.push_back(parallelogram({place(i % columns), place(i / columns), 1.0f},
                                         {pitch / 4, 0.0f, 0.0f}, {0.0f, pitch / 4, 0.0f}));
  return scene_of(setup);
}

constexpr std::string_view kLambert = "Lambert's polygon formula on the visible polygon";

std::vector<StressCase> light_and_occluder_cases() {
  return {
      {"light-aspect", "light", "length of the light over its width, in a penumbra", kLambert,
       settings({1, 10, 100, 1e3, 1e4, 1e5}, aspect)},
      {"light-distance", "light", "distance in lengths of the light, in a penumbra", kLambert,
       settings({1e-4, 1e-3, 0.01, 0.1, 1, 10, 100, 1e3, 1e4}, distance)},
      {"grazing-light", "light", "distance from the plane of a light beside the receiver", kLambert,
       settings({1, 0.1, 0.01, 1e-3, 1e-4, 1e-5}, grazing)},
      {"horizon", "light", "share of the light's height that is above the horizon", kLambert,
       settings({1, 0.5, 0.1, 0.01, 1e-3, 1e-4, 1e-5}, horizon)},
      {"light-corner", "light", "distance of the receiver from a corner of the light", kLambert,
       settings({1, 0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6}, corner)},
      {"contact", "occluder", "gap between receiver and occluder", kLambert,
       settings({1, 0.1, 0.01, 1e-3, 1e-4, 1e-5}, contact)},
      {"edge-direction", "occluder", "angle of the shadow edge to the light's long sides, degrees",
       kLambert, settings({0, 0.1, 1, 10, 45, 80, 89, 89.9, 90}, edge_direction)},
      {"blinds", "occluder", "slats over four widths of the penumbra", kLambert,
       settings({1, 10, 100, 1e3, 1e4}, blinds)},
      {"needles", "occluder", "occluder cut into this many slivers", kLambert,
       settings({1, 10, 100, 1e3, 1e4, 1e5}, needles)},
      {"tessellation", "occluder", "triangles of the occluder", kLambert,
       settings({100, 1e3, 1e4, 1e5, 1e6}, tessellation)},
      {"degenerate", "occluder", "faces that a mesh should not have", kLambert,
       degenerate_settings()},
  };
}

std::vector<StressCase> scene_cases() {
  return {
      {"scale", "scene", "size of the scene", kLambert,
       settings({1e-6, 1e-4, 0.01, 1, 100, 1e4, 1e6}, scaled)},
      {"offset", "scene", "distance of the scene from the origin, in its own size", kLambert,
       settings({0, 1, 10, 100, 1e3, 1e4, 1e5, 1e6}, offset)},
      {"bright-pair", "scene", "radiance of a hidden light over that of the visible one", kLambert,
       settings({1, 10, 100, 1e3, 1e4, 1e5, 1e6}, bright_pair)},
      {"many-lights", "scene", "lights of one power", kLambert,
       settings({1, 10, 100, 1000}, many_lights)},
  };
}

// The families one after the other.
std::vector<StressCase> make_cases() {
  std::vector<StressCase> all = light_and_occluder_cases();
  for (const std::vector<StressCase>& more : {surface_cases(), scene_cases()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace
}  // namespace stress

std::span<const StressCase> stress_cases() {
  static const std::vector<StressCase> all = stress::make_cases();
  return all;
}

std::vector<std::string> stress_case_names() {
  std::vector<std::string> names;
  for (const StressCase& c : stress_cases()) names.emplace_back(c.name);
  return names;
}

}  // namespace raytracing
