#include "mtl_surface.h"

#include <fmt/format.h>

namespace raytracing {
namespace {

/// Stands in for a roughness that the file does not state.
constexpr float kDefaultRoughness = 0.5f;

/// True for the illumination models that ask for mirrors or glass (3 to 9).
bool asks_for_ray_tracing(int illum) { return illum >= 3 && illum <= 9; }

Rgb reflectance(const MtlMaterial& mtl, LoadReport& report) {
  if (!mtl.Kd) {
    report.add(LoadReport::Severity::warning, "material without Kd, 0.5 grey is used", mtl.where);
    return Diffuse{}.reflectance;
  }
  if (max_component(*mtl.Kd) > 1) {
    throw InputError(mtl.where, fmt::format("material '{}': no component of Kd may exceed 1, "
                                            "or the surface would reflect more than it receives",
                                            mtl.name));
  }
  return *mtl.Kd;
}

GgxConductor conductor(const MtlMaterial& mtl, LoadReport& report) {
  if (!mtl.Pr) {
    report.add(LoadReport::Severity::repaired, "material with Pm but without Pr, 0.5 is used",
               mtl.where);
  }
  const float roughness = mtl.Pr.value_or(kDefaultRoughness);
  const float alpha = roughness * roughness;
  if (!(alpha > 0 && alpha <= 1)) {
    throw InputError(mtl.where, fmt::format("material '{}': Pr is {}, but a rough conductor needs "
                                            "a roughness in (0,1]",
                                            mtl.name, roughness));
  }
  return {reflectance(mtl, report), alpha, Fresnel::none};
}

void report_ignored(const MtlMaterial& mtl, LoadReport& report) {
  const auto ignore = [&](bool present, const char* kind) {
    if (present) report.add(LoadReport::Severity::ignored, kind, mtl.where);
  };
  const bool metal = mtl.Pm.value_or(0) == 1;
  ignore(!metal && mtl.Ks && !is_black(*mtl.Ks), "Ks (specular reflectance without Pm)");
  ignore(!metal && mtl.Pr, "Pr (roughness without Pm)");
  ignore(mtl.d.value_or(1) < 1, "d or Tr (transparency)");
  ignore(!metal && mtl.illum && asks_for_ray_tracing(*mtl.illum), "illum (mirrors and glass)");
}

}  // namespace

Surface surface_from_mtl(const MtlMaterial& mtl, LoadReport& report) {
  const float metallic = mtl.Pm.value_or(0);
  if (metallic != 0 && metallic != 1) {
    throw InputError(mtl.where, fmt::format("material '{}': Pm is {}, but must be 0 or 1: blends "
                                            "of metal and non-metal are not modelled",
                                            mtl.name, metallic));
  }
  report_ignored(mtl, report);
  Surface surface{mtl.name, Material{}, mtl.Ke.value_or(Rgb(0.0f))};
  if (metallic == 1) {
    surface.material = conductor(mtl, report);
  } else {
    surface.material = Diffuse{reflectance(mtl, report)};
  }
  return surface;
}

}  // namespace raytracing
