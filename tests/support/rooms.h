#pragma once

#include "support/scenes.h"

namespace raytracing {

/// A room with a metal ball: several bounces, two materials, shadows.
inline Scene metal_ball_room() {
  SceneMaker maker;
  const auto wall = maker.add_surface(Diffuse{Rgb(0.7f, 0.5f, 0.3f)});
  const auto light = maker.add_surface(Diffuse{Rgb(0.0f)}, Rgb(5.0f, 4.0f, 3.0f));
  maker.description.meshes.push_back(inward_box(1, wall));
  maker.add_polygon(parallelogram({0, 0.95f, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}), light);
  maker.add_sphere({0.2f, -0.6f, -0.2f}, 0.4f, maker.add_surface(GgxConductor{Rgb(0.9f), 0.16f}));
  maker.description.camera = {{0.0f, 0.1f, 0.95f}, {0.0f, -0.1f, 0.0f}, {0.0f, 1.0f, 0.0f}, 70};
  return maker.build();
}

}  // namespace raytracing
