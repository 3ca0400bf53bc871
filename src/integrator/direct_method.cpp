#include "raytracing/integrator/direct_method.h"

#include <array>
#include <cmath>

#include "direct_methods.h"
#include "raytracing/lights/chord_sample.h"
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
    DirectMethod{"line-rays",
                 "one chord of the light, average over --line-rays stratified points on it",
                 "--line-rays shadow rays", true, estimate_line_rays, area_pdf_w},
    DirectMethod{"line",
                 "one chord of the light, its exact visible parts; in closed form where diffuse",
                 "1 segment query", true, estimate_line, chord_pdf_w, true},
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

Rgb one_direction(const DirectQuery& query, const Vec3& wi, const Rgb& f_cos, float visible,
                  float pdf_w) {
  if (query.directions != nullptr)
    query.directions->push_back(
        {wi, query.light.Le * (visible / pdf_w), query.light_pmf * pdf_w});
  return query.light.Le * f_cos * (visible * light_sample_weight(query, wi, pdf_w) / pdf_w);
}

Rgb light_point(const DirectQuery& query, Visibility& visibility, const Vec3& q, float pdf_w) {
  // The density is infinite for a vertex in the light's own plane, to which it sends nothing.
  if (!(pdf_w > 0 && std::isfinite(pdf_w))) return Rgb(0.0f);
  const Vec3 wi = normalize(q - query.vertex.position);
  const Rgb f_cos = reflected(query.vertex, wi);
  if (is_black(f_cos) || visibility.occluded(query.vertex, q, query.light)) return Rgb(0.0f);
  return one_direction(query, wi, f_cos, 1, pdf_w);
}

}  // namespace raytracing
