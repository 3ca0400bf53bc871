#pragma once

#include <concepts>
#include <optional>
#include <variant>

#include "raytracing/materials/diffuse.h"
#include "raytracing/materials/ggx.h"

namespace raytracing {

/// The closed set of surface reflectances. To add one, write its struct in a header of its own and
/// name it here. The compiler then asks for what each must have: eval_cos, bsdf_pdf_w, sample_bsdf
/// and lobe_shape by the conventions of bsdf_sample.h; the constants kLambertian and kWantsMis; and
/// its place wherever kinds are told apart (by `visit_material`). materials_lobe_test asks for
/// examples of it, and holds its lobe_shape against its eval_cos and bsdf_pdf_w.
using Material = std::variant<Diffuse, GgxConductor>;

/// Calls `f` with the material's own kind. `f` must take every kind, or the program does not
/// compile. It asks the kinds in turn: std::visit would not be inlined.
template <class F, std::size_t I = 0>
auto visit_material(const Material& material, const F& f) {
  if constexpr (I + 1 < std::variant_size_v<Material>) {
    if (const auto* kind = std::get_if<I>(&material)) return f(*kind);
    return visit_material<F, I + 1>(material, f);
  } else {
    return f(*std::get_if<I>(&material));
  }
}

// These take a Material only, not a kind that converts to one: the function of a kind that is
// missing would otherwise be found here, and call itself.

/// f(wo,wi) |cos wi|.
template <std::same_as<Material> M>
Rgb eval_cos(const M& material, const Vec3& wo, const Vec3& wi) {
  return visit_material(material, [&](const auto& kind) { return eval_cos(kind, wo, wi); });
}

/// A direction with density bsdf_pdf_w. Nothing when the sample points below the surface: it then
/// carries no light.
template <std::same_as<Material> M>
std::optional<BsdfSample> sample_bsdf(const M& material, const Vec3& wo, const Vec2& u) {
  return visit_material(material, [&](const auto& kind) { return sample_bsdf(kind, wo, u); });
}

template <std::same_as<Material> M>
float bsdf_pdf_w(const M& material, const Vec3& wo, const Vec3& wi) {
  return visit_material(material, [&](const auto& kind) { return bsdf_pdf_w(kind, wo, wi); });
}

template <std::same_as<Material> M>
LobeShape lobe_shape(const M& material) {
  return visit_material(material, [](const auto& kind) { return lobe_shape(kind); });
}

/// Whether f is constant: the reflected light is the same for all viewers, and follows from the
/// irradiance.
inline bool is_lambertian(const Material& material) {
  return visit_material(material, [](const auto& kind) { return kind.kLambertian; });
}

/// Whether light that BSDF sampling finds should share the work with light sampling.
inline bool wants_mis(const Material& material) {
  return visit_material(material, []<class Kind>(const Kind&) {
    static_assert(!(Kind::kLambertian && Kind::kWantsMis), "a closed form has no weight for MIS");
    return Kind::kWantsMis;
  });
}

}  // namespace raytracing
