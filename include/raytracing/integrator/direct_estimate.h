#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "raytracing/integrator/ray_queries.h"
#include "raytracing/materials/material.h"
#include "raytracing/sampling/sampler.h"

namespace raytracing {

/// One question to a direct-light method: how much of the light's radiance does the vertex reflect
/// to its viewer, without a bounce in between?
struct DirectQuery {
  const Vertex& vertex;
  const AreaLight& light;
  float light_pmf;             ///< probability with which this light was chosen, in (0,1]
  Vec2 u;                      ///< the pair of uniform numbers that every method may use
  const PathSampler& sampler;  ///< further numbers: sampler.extra(pair, i)
  std::uint32_t pair;          ///< the number of the pair `u`
  int line_rays;               ///< rays per chord of the methods that count rays, >= 1
};

/// One direction of an estimate, without the factors that depend on the viewer. In expectation the
/// vertex reflects the sum of f cos times `light` over the directions of an estimate.
struct LightSample {
  Vec3 wi;            ///< direction to the light, world space, unit, above both horizons
  Rgb light;          ///< radiance over density: share Le V / light_pdf_w
  float light_pdf_w;  ///< density per steradian, times the probability of the light
};

/// Returns the weight of the balance heuristic (Veach & Guibas 1995, eq. 14) for a sample of the
/// density `pdf` when another strategy, with one sample too, chooses it with the density
/// `other_pdf`. Both densities must have the same measure; one of them must be positive.
inline float balance_heuristic(float pdf, float other_pdf) { return pdf / (pdf + other_pdf); }

/// Returns whether the direction wi (world) lies above the horizons of both normals of the vertex.
inline bool is_above_horizons(const Vertex& vertex, const Vec3& wi) {
  return dot(wi, vertex.ng) > 0 && dot(wi, vertex.shading.z) > 0;
}

/// Returns f(wo,wi) |cos wi| of the vertex for the direction wi (world, unit); black below either
/// horizon.
inline Rgb reflected(const Vertex& vertex, const Vec3& wi) {
  if (dot(wi, vertex.ng) <= 0) return Rgb(0.0f);
  return eval_cos(*vertex.material, vertex.wo, vertex.shading.to_local(wi));
}

/// The estimate of the direct light at one vertex. A method can only add light to it. The sum, the
/// MIS weights, the division by the light's probability and the record for shared paths are made
/// here, so that they agree whatever the method does.
class DirectEstimate {
 public:
  /// With `uses_mis`, each direction gets the weight of the balance heuristic (Veach & Guibas 1995,
  /// eq. 14) against BSDF sampling. `samples`, where given, receives every direction. Keeps a
  /// reference to `query`.
  DirectEstimate(const DirectQuery& query, bool uses_mis, RayQueries& rays,
                 std::vector<LightSample>* samples = nullptr)
      : query_(query), uses_mis_(uses_mis), rays_(rays), samples_(samples) {}
  DirectEstimate(const DirectQuery&& temporary, bool uses_mis, RayQueries& rays,
                 std::vector<LightSample>* samples = nullptr) = delete;

  /// Adds the light of the point `q`, chosen with the density `pdf_w` per steradian as seen from
  /// the vertex, if a shadow ray finds it unoccluded. A method that adds n points gives each the
  /// `share` 1/n. A density that is infinite, zero or NaN adds nothing: the vertex then lies in the
  /// light's own plane or behind it, where no light arrives.
  void add_point(const Vec3& q, float pdf_w, float share = 1) {
    if (!is_usable(pdf_w)) return;
    const Vec3 wi = normalize(q - query_.vertex.position);
    const Rgb f_cos = reflected(query_.vertex, wi);
    if (!is_wanted(wi, f_cos) || rays_.occluded(query_.vertex, q, query_.light)) return;
    add(wi, f_cos, pdf_w, share);
  }

  /// Adds the light that arrives along `wi` (world, unit), for a method that knows its visibility.
  /// `pdf_w` is the density per steradian without occluders; `share` is the visible fraction of
  /// what the direction stands for, in [0,1].
  void add_direction(const Vec3& wi, float pdf_w, float share) {
    if (!is_usable(pdf_w)) return;
    const Rgb f_cos = reflected(query_.vertex, wi);
    if (is_wanted(wi, f_cos)) add(wi, f_cos, pdf_w, share);
  }

  /// Adds light in closed form: `irradiance` is the integral of V cos over the light's directions,
  /// for unit radiance. It determines the reflected light of a Lambertian surface only; for all
  /// others it adds nothing.
  void add_irradiance(float irradiance) {
    const Vertex& v = query_.vertex;
    if (irradiance == 0 || !is_lambertian(*v.material)) return;
    // At wi = normal, f cos is f itself: reflectance / pi.
    sum_ += query_.light.Le * reflected(v, v.shading.z) * irradiance;
  }

  /// The reflected radiance, divided by the probability of the light.
  Rgb radiance() const { return sum_ * (1 / query_.light_pmf); }

 private:
  static bool is_usable(float pdf_w) { return pdf_w > 0 && std::isfinite(pdf_w); }

  // Whether light along wi counts: for the viewer of the vertex or, where the directions are
  // recorded, for any viewer.
  bool is_wanted(const Vec3& wi, const Rgb& f_cos) const {
    return samples_ != nullptr ? is_above_horizons(query_.vertex, wi) : !is_black(f_cos);
  }

  void add(const Vec3& wi, const Rgb& f_cos, float pdf_w, float share) {
    const Vertex& v = query_.vertex;
    if (samples_ != nullptr)
      samples_->push_back(
          {wi, query_.light.Le * (share / pdf_w) / query_.light_pmf, query_.light_pmf * pdf_w});
    float weight = share;
    if (uses_mis_)
      weight *= balance_heuristic(query_.light_pmf * pdf_w,
                                  bsdf_pdf_w(*v.material, v.wo, v.shading.to_local(wi)));
    sum_ += query_.light.Le * f_cos * (weight / pdf_w);
  }

  const DirectQuery& query_;
  const bool uses_mis_;
  RayQueries& rays_;
  std::vector<LightSample>* const samples_;
  Rgb sum_{0.0f};
};

}  // namespace raytracing
