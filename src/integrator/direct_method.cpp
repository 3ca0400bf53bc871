#include "raytracing/integrator/direct_method.h"

#include <array>

#include "direct_methods.h"
#include "raytracing/materials/bsdf.h"
#include "raytracing/sampling/warp.h"

namespace raytracing {
namespace {

constexpr std::array kMethods{
    DirectMethod{"point", "one point of the light, uniform in area", "1 shadow ray", true,
                 estimate_point, area_pdf_w},
    DirectMethod{"solid-angle", "one point of the light, uniform in the solid angle it fills",
                 "1 shadow ray", true, estimate_solid_angle, solid_angle_pdf_w},
    DirectMethod{"line-ratio",
                 "one chord of the light, one random point on it, times the fraction of "
                 "--line-rays rays to the chord that arrive",
                 "--line-rays shadow rays", false, estimate_line_ratio, nullptr},
};

}  // namespace

bool DirectMethod::uses_mis(const Material& material) const {
  return pdf_w != nullptr && wants_mis(material);
}

std::span<const DirectMethod> direct_methods() { return kMethods; }

const DirectMethod* find_direct_method(std::string_view name) {
  for (const DirectMethod& method : kMethods)
    if (method.name == name) return &method;
  return nullptr;
}

std::vector<std::string> direct_method_names() {
  std::vector<std::string> names;
  for (const DirectMethod& method : kMethods) names.emplace_back(method.name);
  return names;
}

Rgb reflected(const Vertex& vertex, const Vec3& wi) {
  if (dot(wi, vertex.ng) <= 0) return Rgb(0.0f);
  return eval_cos(*vertex.material, vertex.wo, vertex.shading.to_local(wi));
}

float light_sample_weight(const DirectQuery& query, const Vec3& wi, float pdf_w) {
  const Vertex& v = query.vertex;
  if (!wants_mis(*v.material)) return 1;
  const float bsdf = bsdf_pdf_w(*v.material, v.wo, v.shading.to_local(wi));
  return balance_heuristic(query.light_pmf * pdf_w, bsdf);
}

}  // namespace raytracing
