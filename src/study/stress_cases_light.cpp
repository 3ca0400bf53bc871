// Cases of the light's shape and place.

#include <algorithm>

#include "stress_maker.h"

namespace raytracing::stress {
namespace {

constexpr std::string_view kFamily = "light";
constexpr std::string_view kLambert = "Lambert's polygon formula on the visible polygon";

StressScene aspect(float ratio) {
  Maker maker;
  const Vec3 center(0.113f, 0.043f, 1.0f);
  maker.add_light(parallelogram(center, {0.5f, 0.0f, 0.0f}, {0.0f, 0.5f / ratio, 0.0f}));
  maker.add_occluder(edge_occluder(0.5f, center, 0.5f));
  return maker.scene;
}

// The light keeps its size; the occluder stays half way, its shadow edge above the receiver, where
// a near light is brightest.
StressScene distance(float d) {
  const float near = std::min(d, 1.0f);
  Maker maker(kGrey, kView, std::min(0.01f, 0.2f * d));
  maker.add_light(parallelogram({0.113f, 0.043f, d}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.35f, 0.0f}));
  const Vec3 target = kPoint + Vec3(0.1f * near, 0.05f * near, d);
  maker.add_occluder(edge_occluder(d / 2, target, 0.5f, 0.01f * near, 0.5f));
  return maker.scene;
}

// A wall of light across the x axis, seen over the receiver from its side.
StressScene wall(const Vec3& center, float half_height = 0.5f) {
  Maker maker(kGrey, {-0.48f, -0.36f, 0.8f});
  maker.add_light(parallelogram(center, {0.0f, 0.5f, 0.0f}, {0.0f, 0.0f, half_height}));
  return maker.scene;
}

// A wall in the plane x = g from the receiver, beside it.
StressScene grazing(float g) { return wall(kPoint + Vec3(g, 1.0f, 0.6f), 0.4f); }

// A wall that reaches `above` over the horizon, and the rest of its height of 1 below.
StressScene horizon(float above) { return wall(Vec3(1.0f, 0.1f, above - 0.5f)); }

// A wall that stands on the receiver's plane, one corner at the distance d.
StressScene corner(float d) { return wall(kPoint + Vec3(d, 0.5f, 0.5f)); }

}  // namespace

std::vector<StressCase> light_cases() {
  return {
      {"light-aspect", kFamily, "length of the light over its width, in a penumbra", kLambert,
       settings({1, 10, 100, 1e3, 1e4, 1e5}, aspect)},
      {"light-distance", kFamily, "distance in lengths of the light, in a penumbra", kLambert,
       settings({1e-4, 1e-3, 0.01, 0.1, 1, 10, 100, 1e3, 1e4}, distance)},
      {"grazing-light", kFamily, "distance from the plane of a light beside the receiver", kLambert,
       settings({1, 0.1, 0.01, 1e-3, 1e-4, 1e-5}, grazing)},
      {"horizon", kFamily, "share of the light's height that is above the horizon", kLambert,
       settings({1, 0.5, 0.1, 0.01, 1e-3, 1e-4, 1e-5}, horizon)},
      {"light-corner", kFamily, "distance of the receiver from a corner of the light", kLambert,
       settings({1, 0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6}, corner)},
  };
}

}  // namespace raytracing::stress
