#include "raytracing/materials/bsdf.h"

#include "diffuse.h"
#include "ggx.h"

namespace raytracing {

Rgb eval_cos(const Material& material, const Vec3& wo, const Vec3& wi) {
  return std::visit([&](const auto& m) { return eval_cos(m, wo, wi); }, material);
}

std::optional<BsdfSample> sample_bsdf(const Material& material, const Vec3& wo, const Vec2& u) {
  return std::visit([&](const auto& m) { return sample_bsdf(m, wo, u); }, material);
}

float bsdf_pdf_w(const Material& material, const Vec3& wo, const Vec3& wi) {
  return std::visit([&](const auto& m) { return bsdf_pdf_w(m, wo, wi); }, material);
}

}  // namespace raytracing
