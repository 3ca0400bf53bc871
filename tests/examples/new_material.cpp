// A material more: a grey Lambertian surface of fixed reflectance, the example of src/README.md.
// The tests new_material_without_* compile it whole, and without each of its parts in turn, which
// must not compile.

#include <optional>

#include "raytracing/materials/diffuse.h"
#include "raytracing/materials/ggx.h"

namespace raytracing {

struct Grey {
#ifndef WITHOUT_kLambertian
  static constexpr bool kLambertian = true;
#endif
#ifndef WITHOUT_kWantsMis
  static constexpr bool kWantsMis = false;
#endif
};

#ifndef WITHOUT_eval_cos
inline Rgb eval_cos(const Grey&, const Vec3&, const Vec3& wi) {
  return Rgb(0.5f * cosine_hemisphere_pdf_w(wi.z));
}
#endif

#ifndef WITHOUT_bsdf_pdf_w
inline float bsdf_pdf_w(const Grey&, const Vec3&, const Vec3& wi) {
  return cosine_hemisphere_pdf_w(wi.z);
}
#endif

#ifndef WITHOUT_sample_bsdf
inline std::optional<BsdfSample> sample_bsdf(const Grey&, const Vec3& wo, const Vec2& u) {
  return sample_bsdf(Diffuse{Rgb(0.5f)}, wo, u);
}
#endif

#ifndef WITHOUT_lobe_shape
inline LobeShape lobe_shape(const Grey&) { return LobeShape::lambertian(Rgb(0.5f)); }
#endif

}  // namespace raytracing

// A copy of the header of materials whose variant names Grey, too.
#include "raytracing/materials/material.h"

namespace raytracing {

static_assert(std::is_same_v<std::variant_alternative_t<0, Material>, Grey>);

bool uses_every_part(const Material& material, const Vec3& w, const Vec2& u) {
  const Rgb value = eval_cos(material, w, w) + lobe_shape(material).reflectance;
  return value.x > bsdf_pdf_w(material, w, w) && sample_bsdf(material, w, u) &&
         is_lambertian(material) && wants_mis(material);
}

}  // namespace raytracing
