// Fuzzes the MTL parser and the surfaces made from its materials: values are valid or there is a
// one-line error with its location, and every record is kept or counted.

#include <cmath>

#include "fuzz.h"
#include "raytracing/io/mtl.h"
#include "records.h"

namespace raytracing::fuzz {
namespace {

bool in_unit_cube(const Rgb& c) {
  return c.x >= 0 && c.x <= 1 && c.y >= 0 && c.y <= 1 && c.z >= 0 && c.z <= 1;
}

void check_surface(const Surface& surface) {
  for (int i = 0; i < 3; ++i)
    require(surface.Le[i] >= 0 && std::isfinite(surface.Le[i]), "radiance is finite and >= 0");
  if (const auto* diffuse = std::get_if<Diffuse>(&surface.material))
    require(in_unit_cube(diffuse->reflectance), "no surface reflects more than it receives");
  if (const auto* ggx = std::get_if<GgxConductor>(&surface.material)) {
    require(in_unit_cube(ggx->reflectance), "no metal reflects more than it receives");
    require(ggx->alpha > 0 && ggx->alpha <= 1, "alpha is in (0,1]");
  }
}

void check_counts(std::string_view text, std::size_t materials, const LoadReport& report) {
  auto records = count_records(text, {"newmtl"});
  require(records["newmtl"] ==
              materials + count(report, LoadReport::Severity::warning, "material defined twice"),
          "every newmtl is a material or reported");
  for (const char* known : {"newmtl", "Kd", "Ks", "Ke", "Ns", "Ni", "d", "Tr", "Pr", "Pm", "illum"})
    records.erase(known);
  check_ignored(records, report, "MTL key");
}

}  // namespace
}  // namespace raytracing::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace raytracing;
  const auto parse = [](const std::string& text, LoadReport& report) {
    const std::vector<MtlMaterial> materials = parse_mtl(text, "x.mtl", report);
    fuzz::check_counts(text, materials.size(), report);
    fuzz::check_report(report, text);
    for (const MtlMaterial& material : materials)
      fuzz::check_surface(surface_from_mtl(material, report));
  };
  return fuzz::read_text(data, size, parse, [](const std::string&, std::string_view what) {
    fuzz::check_message(what, "x.mtl", true);
  });
}
