// Cases of the scene's numbers: scale, offset, many lights.

#include "stress_maker.h"

namespace raytracing::stress {
namespace {

constexpr std::string_view kFamily = "scene";
constexpr std::string_view kLambert = "Lambert's polygon formula on the visible polygon";

StressScene scaled(float s) { return transformed(penumbra(), s, Vec3(0.0f)); }

// What the coordinates then round to is the scene; a larger receiver, that some of it remains.
StressScene offset(float o) {
  return transformed(penumbra(0.3f, 0.5f), 1, Vec3(o, -0.7f * o, 0.4f * o));
}

// The bright light is hidden; lights are chosen by their power all the same.
StressScene bright_pair(float ratio) {
  Maker maker;
  const Vec3 x(0.15f, 0.0f, 0.0f), y(0.0f, 0.15f, 0.0f);
  maker.add_light(parallelogram({-0.6f, 0.0f, 1.0f}, x, y), ratio);
  maker.add_light(parallelogram({0.6f, 0.0f, 1.0f}, x, y));
  maker.add_occluder(parallelogram({-0.3f, 0.0f, 0.5f}, {0.2f, 0.0f, 0.0f}, {0.0f, 0.3f, 0.0f}));
  return maker.scene;
}

// Over 2 x 2, a quarter of it luminous.
StressScene many_lights(float count) {
  Maker maker;
  const int n = static_cast<int>(count);
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const float pitch = 2 / static_cast<float>(columns);
  for (int i = 0; i < n; ++i) {
    const float x = (static_cast<float>(i % columns) + 0.5f) * pitch - 1;
    const float y = (static_cast<float>(i / columns) + 0.5f) * pitch - 1;
    maker.add_light(parallelogram({x, y, 1.0f}, {pitch / 4, 0.0f, 0.0f}, {0.0f, pitch / 4, 0.0f}));
  }
  maker.add_occluder(edge_occluder(0.5f, {0.113f, 0.043f, 1.0f}, 0.5f));
  return maker.scene;
}

}  // namespace

std::vector<StressCase> scene_cases() {
  return {
      {"scale", kFamily, "size of the scene", kLambert,
       settings({1e-6, 1e-4, 0.01, 1, 100, 1e4, 1e6}, scaled)},
      {"offset", kFamily, "distance of the scene from the origin, in its own size", kLambert,
       settings({0, 1, 10, 100, 1e3, 1e4, 1e5, 1e6}, offset)},
      {"bright-pair", kFamily, "radiance of a hidden light over that of the visible one", kLambert,
       settings({1, 10, 100, 1e3, 1e4, 1e5, 1e6}, bright_pair)},
      {"many-lights", kFamily, "lights of one power", kLambert,
       settings({1, 10, 100, 1000}, many_lights)},
  };
}

}  // namespace raytracing::stress
