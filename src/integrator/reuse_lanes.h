#pragma once
// Reflection by many surfaces at once: one array per quantity, one lane per surface, in loops that
// the compiler vectorises.

#include <algorithm>
#include <array>
#include <cmath>

#include "raytracing/materials/material.h"
#include "raytracing/math/numeric.h"
#include "raytracing/math/vec.h"

namespace raytracing {

inline constexpr int kMaxLanes = 256;
using Lanes = std::array<float, kMaxLanes>;

struct alignas(64) Vec3Lanes {
  Lanes x, y, z;

  Vec3 at(int k) const { return {x[k], y[k], z[k]}; }
  void set(int k, const Vec3& v) {
    x[k] = v.x;
    y[k] = v.y;
    z[k] = v.z;
  }
};

/// What a surface does with light from one direction: eval_cos is `value` times the reflectance at
/// the angle, in which white has the weight `white`.
struct Lobe {
  float pdf_w;  ///< as bsdf_pdf_w
  float value;
  float white;
};

/// A material in plain numbers. Both kinds of it are computed and one is chosen, without branches.
struct LobeShape {
  float ggx = 0;      ///< 1 = GGX, 0 = diffuse
  float alpha2 = 1;   ///< alpha squared
  float schlick = 0;  ///< 1 = with Schlick's weight of white
  Rgb reflectance{0.0f};

  explicit LobeShape(const Material& material) {
    if (const auto* diffuse = std::get_if<Diffuse>(&material)) {
      reflectance = diffuse->reflectance;
    } else {
      const auto& conductor = std::get<GgxConductor>(material);
      ggx = 1;
      alpha2 = square(conductor.alpha);
      schlick = conductor.fresnel == Fresnel::schlick ? 1.0f : 0.0f;
      reflectance = conductor.reflectance;
    }
  }
};

/// The lobe of a diffuse surface at this cosine.
inline Lobe diffuse_lobe(float cos_i) { return {cos_i * kInvPi, cos_i * kInvPi, 0}; }

/// The lobe of the unit shading normal n for the unit directions wo and wi, all in world space: the
/// formulas of ggx.h without its frame. Only for directions above the horizon of n.
inline Lobe lobe(float is_ggx, float alpha2, float is_schlick, const Vec3& n, const Vec3& wo,
                 const Vec3& wi) {
  const float cos_o = dot(n, wo), cos_i = dot(n, wi);
  const Vec3 sum = wo + wi, turned = cross(n, sum);
  const float length2 = dot(sum, sum);
  const float k = (dot(turned, turned) / alpha2 + square(dot(n, sum))) / length2;
  const float distribution = 1 / (kPi * alpha2 * square(k));
  const float stretched_o = std::sqrt(alpha2 + (1 - alpha2) * square(cos_o));
  const float stretched_i = std::sqrt(alpha2 + (1 - alpha2) * square(cos_i));
  const float c = std::max(1 - std::sqrt(length2) / 2, 0.0f);
  const float pdf_w = distribution / (2 * (cos_o + stretched_o));
  const float value = distribution * 0.5f * cos_i / (cos_i * stretched_o + cos_o * stretched_i);
  const bool ggx = is_ggx > 0;
  const float diffuse = cos_i * kInvPi;
  return {ggx ? pdf_w : diffuse, ggx ? value : diffuse, is_schlick * square(square(c)) * c};
}

/// Sum of the first n lanes, in one fixed order.
inline float sum(const Lanes& lanes, int n) {
  std::array<float, 8> partial{};
  for (int k = 0; k < n; k += 8)
    for (int i = 0; i < 8; ++i) partial[i] += lanes[k + i];
  for (int step = 4; step > 0; step /= 2)
    for (int i = 0; i < step; ++i) partial[i] += partial[i + step];
  return partial[0];
}

}  // namespace raytracing
