#include "raytracing/integrator/direct_method.h"

#include <array>
#include <stdexcept>

#include "direct_methods.h"
#include "raytracing/lights/chord.h"
#include "raytracing/materials/bsdf.h"

namespace raytracing {
namespace {

// Colours of Okabe and Ito, which the colour-blind can tell apart.
constexpr std::array kMethods{
    DirectMethod{"point", "one point of the light, uniform in area", "1 shadow ray", true,
                 "#e69f00", 7, estimate_point, area_pdf_w},
    DirectMethod{"solid-angle", "one point of the light, uniform in the solid angle it fills",
                 "1 shadow ray", true, "#d55e00", 5, estimate_solid_angle, solid_angle_pdf_w},
    DirectMethod{"line-ratio",
                 "one chord of the light, one random point on it, times the fraction of "
                 "--line-rays rays to the chord that arrive",
                 "--line-rays shadow rays", false, "#cc79a7", 8, estimate_line_ratio, nullptr},
    DirectMethod{"line-rays",
                 "one chord of the light, average over --line-rays stratified points on it",
                 "--line-rays shadow rays", true, "#56b4e9", 13, estimate_line_rays, area_pdf_w},
    DirectMethod{"line",
                 "one chord of the light, its exact visible parts; in closed form where diffuse",
                 "1 segment query", true, "#000000", 9, estimate_line, chord_pdf_w, true},
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

const DirectMethod& direct_method(std::string_view name) {
  if (const DirectMethod* method = find_direct_method(name)) return *method;
  throw std::logic_error("no method is called " + std::string(name));
}

std::vector<std::string> direct_method_names() {
  std::vector<std::string> names;
  for (const DirectMethod& method : kMethods) names.emplace_back(method.name);
  return names;
}

}  // namespace raytracing
