#include "raytracing/integrator/direct_method.h"

#include <array>

#include "direct_methods.h"
#include "raytracing/lights/chord_sample.h"
#include "raytracing/materials/bsdf.h"

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

}  // namespace raytracing
