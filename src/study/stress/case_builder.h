#pragma once
// Building blocks of the scenes of the stress cases.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "raytracing/study/stress/cases.h"

namespace raytracing::stress {

using Polygon = std::vector<Vec3>;

/// The point of the receivers that is looked at: off the origin, so that no formula meets a zero by
/// chance.
inline constexpr Vec3 kPoint{0.013f, -0.007f, 0.0f};
/// The direction towards the viewer, unless a case chooses its own.
inline constexpr Vec3 kView{0.48f, -0.36f, 0.8f};
/// The material of the receivers, unless a case chooses its own.
inline const Material kGrey = Diffuse{Rgb(0.5f)};

/// The parallelogram center +- x +- y with the normal cross(x, y).
inline Polygon parallelogram(const Vec3& center, const Vec3& x, const Vec3& y) {
  return {center - x - y, center + x - y, center + x + y, center - x + y};
}

/// The middle of the standard light.
inline constexpr Vec3 kCenter{0.113f, 0.043f, 1.0f};

/// A receiver under lights of radiance 1, behind black convex occluders.
struct Setup {
  std::vector<Polygon> lights;
  std::vector<Polygon> occluders = {};
  Material material = kGrey;
  Vec3 wo = kView;     ///< towards the viewer
  float eye = 0.01f;   ///< distance of the viewer; less than that of the nearest occluder
  float half = 0.02f;  ///< half of the receiver's sides
};
StressScene scene_of(const Setup& setup);

/// Puts a StressScene together that is more than a setup.
class CaseBuilder {
 public:
  /// The setup, whose receiver lies at kPoint with the normal +z.
  explicit CaseBuilder(const Setup& setup = {{}});
  /// A scene without receiver.
  struct Empty {};
  explicit CaseBuilder(Empty) {}

  std::uint32_t add_surface(const Material& material, float Le = 0);
  /// Faces given by the positions of their corners; counter-clockwise from outside.
  void add_faces(const std::vector<Polygon>& faces, std::uint32_t surface);
  /// A light that shines on kPoint, whatever the order of its corners.
  void add_light(Polygon corners, float Le = 1);
  /// A black convex polygon.
  void add_occluder(const Polygon& corners);
  /// Black faces that together hide what the polygon `silhouette` hides.
  void add_occluder(const std::vector<Polygon>& faces, const Polygon& silhouette);
  /// Black faces that change nothing.
  void add_black_faces(const std::vector<Polygon>& faces);

  StressScene scene;

 private:
  std::optional<std::uint32_t> black_;
};

/// A light of 1 x 0.7 at height 1 over the receiver, its longer sides along x.
Polygon ceiling_light();

/// A big square at height `z`. Its edge, at `angle` radians to the x axis, throws its shadow
/// `offset` beside the light point above `target` as seen from kPoint. What lies across is hidden.
/// Unless told otherwise, it is that of the standard scene: at half the height of the ceiling
/// light, through whose middle its shadow edge runs obliquely.
Polygon edge_occluder(float z = 0.5f, const Vec3& target = kCenter, float angle = 0.5f,
                      float offset = 0.01f, float size = 4);

/// The scene with every position p moved to scale * p + shift.
StressScene transformed(StressScene scene, float scale, const Vec3& shift);

/// The label of a value: "0.001", "1e-05", "1e+06".
std::string number_label(double value);

/// One setting for each value, made by `make` from it.
template <class Make>
std::vector<StressSetting> settings(const std::vector<double>& values, const Make& make) {
  std::vector<StressSetting> result;
  for (const double value : values)
    result.push_back(
        {number_label(value), [make, value] { return make(static_cast<float>(value)); }});
  return result;
}

}  // namespace raytracing::stress
