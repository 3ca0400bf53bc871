#include "occluder_cases.h"

#include <algorithm>
#include <random>

#include "case_builder.h"

namespace raytracing::stress {
namespace {

constexpr std::string_view kFamily = "occluder";
constexpr std::string_view kLambert = "Lambert's polygon formula on the visible polygon";
constexpr Vec3 kCenter{0.113f, 0.043f, 1.0f};

StressScene contact(float gap) {
  CaseBuilder builder(kGrey, kView, std::min(0.01f, 0.2f * gap));
  builder.add_light(parallelogram(1.5f * kCenter, {0.5f, 0.0f, 0.0f}, {0.0f, 0.35f, 0.0f}));
  builder.add_occluder(edge_occluder(gap, 1.5f * kCenter, 0.5f, 0.02f * gap, 0.5f));
  return builder.scene;
}

StressScene edge_direction(float degrees) {
  CaseBuilder builder;
  builder.add_light(ceiling_light());
  builder.add_occluder(edge_occluder(0.5f, kCenter, degrees * 3.14159265f / 180));
  return builder.scene;
}

// Slats and slits of equal width alternate over a width of 2, oblique to the light.
StressScene blinds(float count) {
  CaseBuilder builder;
  builder.add_light(ceiling_light());
  const Vec3 along(std::cos(0.3f), std::sin(0.3f), 0.0f), across(-along.y, along.x, 0.0f);
  const int n = static_cast<int>(count);
  const float pitch = 2 / count;
  for (int i = 0; i < n; ++i) {
    const float at = (static_cast<float>(i) + 0.5f) * pitch - 1;
    builder.add_occluder(parallelogram(Vec3(0.06f, 0.02f, 0.5f) + (at + 0.3f * pitch) * across,
                                       along, 0.25f * pitch * across));
  }
  return builder.scene;
}

// The standard occluder as triangles with one corner in common, along whose other sides the shadow
// edge runs.
StressScene needles(float count) {
  CaseBuilder builder;
  builder.add_light(ceiling_light());
  const Polygon square = edge_occluder(0.5f, kCenter, 0.5f);
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
  CaseBuilder builder;
  builder.add_light(ceiling_light());
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
  CaseBuilder builder;
  builder.add_light(ceiling_light());
  const Polygon square = edge_occluder(0.5f, kCenter, 0.5f);
  builder.add_occluder(square);
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

}  // namespace

std::vector<StressCase> occluder_cases() {
  return {
      {"contact", kFamily, "gap between receiver and occluder", kLambert,
       settings({1, 0.1, 0.01, 1e-3, 1e-4, 1e-5}, contact)},
      {"edge-direction", kFamily, "angle of the shadow edge to the light's long sides, degrees",
       kLambert, settings({0, 0.1, 1, 10, 45, 80, 89, 89.9, 90}, edge_direction)},
      {"blinds", kFamily, "slats over four widths of the penumbra", kLambert,
       settings({1, 10, 100, 1e3, 1e4}, blinds)},
      {"needles", kFamily, "occluder cut into this many slivers", kLambert,
       settings({1, 10, 100, 1e3, 1e4, 1e5}, needles)},
      {"tessellation", kFamily, "triangles of the occluder", kLambert,
       settings({100, 1e3, 1e4, 1e5, 1e6}, tessellation)},
      {"degenerate", kFamily, "faces that a mesh should not have", kLambert, degenerate_settings()},
  };
}

}  // namespace raytracing::stress
