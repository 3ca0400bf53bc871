#pragma once
// A receiver, a light and perhaps an occluder: measured by path tracing and by quadrature.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "raytracing/integrator/path_tracer.h"
#include "raytracing/materials/material.h"
#include "raytracing/study/stress/exact_polygons.h"
#include "support/scenes.h"
#include "support/single_paths.h"
#include "support/statistics.h"

namespace raytracing {

inline constexpr float kLe = 3;

struct DirectCase {
  std::string name;
  std::vector<Vec3> light;     ///< radiance kLe, on the side that sees the receiver
  std::vector<Vec3> occluder;  ///< black; empty for none
};

/// A small receiver about the origin, with normal +z, seen from `wo`; one vertex of it is studied.
class DirectScene {
 public:
  DirectScene(const DirectCase& c, const Material& material, const Vec3& wo = {0.48f, -0.36f, 0.8f})
      : scene_(make(c, material)),
        ray_{kReceiver + 0.01f * wo, -wo},
        vertex_(scene_.vertex(ray_, scene_.geometry().closest_hit(ray_).value())),
        light_(long_polygon(c.light)) {
    if (c.occluder.empty()) return;
    // As the shadow rays see it: from their origin, a few float spacings above the vertex.
    const LVec3 from(vertex_.ray_origin());
    dark_ = intersection(light_, shadow(long_polygon(c.occluder), from, light_));
  }

  const Scene& scene() const { return scene_; }
  const Vertex& vertex() const { return vertex_; }
  const LPolygon& light() const { return light_; }
  /// The part of the light that the occluder hides; empty when there is none.
  const LPolygon& dark() const { return dark_; }

  /// Red direct radiance from a diffuse receiver, in closed form.
  double lambert_radiance() const {
    const float rho = std::get<Diffuse>(*vertex_.material).reflectance.x;
    const LVec3 p(vertex_.position), n(vertex_.ng);
    const long double seen = lambert(light_, p, n) - lambert(dark_, p, n);
    return static_cast<double>(seen * kLe * rho / std::numbers::pi_v<long double>);
  }

  /// Red direct radiance from any receiver, by quadrature over the light's visible part.
  double quadrature_radiance() const {
    return kLe * (integral(light_) - (dark_.empty() ? 0.0 : integral(dark_)));
  }

  /// f cos cos_light / r^2 for the point q of the light: the integrand over its area, without Le.
  double integrand(const DVec3& q) const {
    const DVec3 d = q - DVec3(vertex_.position);
    const double r = length(d);
    const DVec3 n(normalize(area_vector(light_)));
    const Vec3 wi = vertex_.shading.to_local(Vec3(d / r));
    const double f_cos = eval_cos(*vertex_.material, vertex_.wo, wi).x;
    return f_cos * std::abs(dot(n, d)) / (r * r * r);
  }

  /// Sample number `sample` of the pixel x: the direct light at the vertex towards the viewer,
  /// by the method and, where it leaves a share to it, by BSDF sampling.
  float sample(const DirectMethod& method, SamplerKind kind, std::uint32_t x,
               std::uint64_t sample) const {
    PathSampler sampler(kind, 1, x, 0, sample);
    return SinglePaths(scene_, {&method, 1}).radiance(ray_, sampler).x;
  }

 private:
  static constexpr Vec3 kReceiver{0.013f, -0.007f, 0.0f};

  static Scene make(const DirectCase& c, const Material& material) {
    SceneMaker maker;
    const auto receiver = maker.add_surface(material);
    const auto light = maker.add_surface(Diffuse{Rgb(0.0f)}, Rgb(kLe));
    const auto black = maker.add_surface(Diffuse{Rgb(0.0f)});
    const Vec3 x(0.02f, 0.0f, 0.0f), y(0.0f, 0.02f, 0.0f);
    maker.add_polygon(parallelogram(Vec3(0.0f), x, y), receiver);
    maker.add_polygon(facing(c.light, kReceiver), light);
    if (!c.occluder.empty()) maker.add_polygon(c.occluder, black);
    return maker.build();
  }

  double integral(const LPolygon& whole) const {
    const LPolygon above = clip(whole, LVec3(vertex_.position), LVec3(vertex_.ng));
    double sum = 0;
    for (std::size_t i = 1; i + 1 < above.size(); ++i) {
      const DVec3 a(above[0]), b(above[i]), c(above[i + 1]);
      const double twice_area = length(cross(b - a, c - a));
      sum += twice_area *
             integrate2([&](double s,
                            double t) { return s * integrand(a + s * (b - a) + s * t * (c - b)); },
                        0, 1, 0, 1, 20);
    }
    return sum;
  }

  Scene scene_;
  Ray ray_;
  Vertex vertex_;
  LPolygon light_, dark_;
};

/// Statistics whose spread is honest: of single samples for independent numbers; of the means of
/// whole pixels, each with its own scrambling, for Sobol' points.
inline RunningStats measure(const DirectScene& scene, const DirectMethod& method, SamplerKind kind,
                            int samples) {
  RunningStats stats;
  if (kind == SamplerKind::independent) {
    for (int i = 0; i < samples; ++i) stats.add(scene.sample(method, kind, 0, i));
    return stats;
  }
  constexpr int kPixels = 256;
  const int per_pixel = std::max(1, samples / kPixels);
  for (int x = 0; x < kPixels; ++x) {
    double sum = 0;
    for (int i = 0; i < per_pixel; ++i) sum += scene.sample(method, kind, x, i);
    stats.add(sum / per_pixel);
  }
  return stats;
}

}  // namespace raytracing
