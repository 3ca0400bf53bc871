#include "group_views.h"

namespace raytracing {
namespace {

// Steps after which rays are asked instead: what fills a shaft so costs less by rays. The time has
// a flat minimum there, from 16 to 64 in the scenes of this repository.
constexpr int kShaftLimit = 32;

}  // namespace

void GroupViews::begin(std::size_t n) {
  lanes_ = static_cast<int>(n + 7) / 8 * 8;
  any_ggx_ = false;
  for (int k = 0; k < lanes_; ++k) {
    first_.clear(k);
    gathered_.set(k, Vec3(0.0f));
  }
}

void GroupViews::set_first(std::size_t k, const Vertex& x) {
  first_.set(static_cast<int>(k), x);
  any_ggx_ |= first_.ggx[k] > 0;
}

void GroupViews::look_at(const Vertex& y, std::size_t owner, Visibility& visibility) {
  const int own = static_cast<int>(owner);
  any_ggx_ ? see<true>(y) : see<false>(y);
  if (y.normal_replaced)
    for (int k = 0; k < lanes_; ++k)
      if (k != own) views_.pdf_a[k] = views_.value[k] = 0;
  hide(y, own, visibility);
}

// As if nothing stood between.
template <bool kAnyGgx>
void GroupViews::see(const Vertex& y) {
  const Vec3 position = y.position, ng = y.ng, ns = y.shading.z;
  for (int k = 0; k < lanes_; ++k) {
    const Vec3 d = position - first_.origin.at(k);
    const float distance2 = dot(d, d);
    const Vec3 wi = d / std::sqrt(distance2);
    const float cos_y = -dot(wi, ng);
    const Vec3 nx = first_.ns.at(k);
    const float above =
        std::min(std::min(cos_y, -dot(wi, ns)), std::min(dot(wi, nx), dot(wi, first_.ng.at(k))));
    Lobe l = diffuse_lobe(dot(wi, nx));
    if constexpr (kAnyGgx)
      l = lobe(first_.ggx[k], first_.alpha2[k], first_.schlick[k], nx, first_.wo.at(k), wi);
    const float geometry = above > 0 ? cos_y / distance2 : 0.0f;
    views_.wo.x[k] = -wi.x;
    views_.wo.y[k] = -wi.y;
    views_.wo.z[k] = -wi.z;
    views_.pdf_a[k] = geometry > 0 ? l.pdf_w * geometry : 0.0f;
    views_.value[k] = geometry > 0 ? l.value * geometry : 0.0f;
    views_.white[k] = geometry > 0 ? l.white : 0.0f;
  }
}

// Takes out the views that something stands in. The owner's bounce has arrived at y.
void GroupViews::hide(const Vertex& y, int owner, Visibility& visibility) {
  const Vec3 from = y.ray_origin();
  const Vec3Lanes& to = first_.origin;
  alignas(64) std::array<std::int32_t, kMaxLanes> wanted;
  for (int k = 0; k < lanes_; ++k) wanted[k] = views_.pdf_a[k] > 0 ? 1 : 0;
  wanted[owner] = 0;
  std::int32_t any = 0;
  for (int k = 0; k < lanes_; ++k) any |= wanted[k];
  if (any == 0) return;
  if (!visibility.keep_visible(from, {to.x.data(), to.y.data(), to.z.data(), lanes_}, wanted.data(),
                               kShaftLimit))
    ask_each(from, wanted, visibility);
  wanted[owner] = 1;
  for (int k = 0; k < lanes_; ++k) {
    views_.pdf_a[k] = wanted[k] != 0 ? views_.pdf_a[k] : 0.0f;
    views_.value[k] = wanted[k] != 0 ? views_.value[k] : 0.0f;
  }
}

// Asks for each ray what a shaft has too much in it to tell.
void GroupViews::ask_each(const Vec3& from, std::array<std::int32_t, kMaxLanes>& wanted,
                          Visibility& visibility) const {
  for (int begin = 0; begin < lanes_; begin += 8) {
    unsigned bits = 0;
    for (int i = 0; i < 8; ++i)
      if (wanted[begin + i] != 0) bits |= 1u << i;
    if (bits == 0) continue;
    const unsigned hidden = visibility.occluded8(
        from, &first_.origin.x[begin], &first_.origin.y[begin], &first_.origin.z[begin], bits);
    for (int i = 0; i < 8; ++i)
      if ((hidden >> i) & 1) wanted[begin + i] = 0;
  }
}

void GroupViews::add_diffuse(const Rgb& light) {
  const float density = sum(views_.pdf_a, lanes_);
  if (!(density > 0)) return;
  const Rgb shared = light / density;
  // Light that has overflowed is nobody's who does not see it.
  const auto add = [&](Lanes& to, const Lanes& reflectance, float amount) {
    for (int k = 0; k < lanes_; ++k) {
      const float here = reflectance[k] + (1 - reflectance[k]) * views_.white[k];
      to[k] += views_.value[k] > 0 ? views_.value[k] * here * amount : 0.0f;
    }
  };
  add(gathered_.x, first_.reflectance.x, shared.x);
  add(gathered_.y, first_.reflectance.y, shared.y);
  add(gathered_.z, first_.reflectance.z, shared.z);
}

void GroupViews::add_glossy(const Term& term, const Vertex& y) {
  const LobeShape shape(*y.material);
  const Vec3 ns = y.shading.z;
  alignas(64) Lanes densities, value, white;
  for (int k = 0; k < lanes_; ++k) {
    const Lobe l = lobe(shape.ggx, shape.alpha2, shape.schlick, ns, views_.wo.at(k), term.wi);
    const bool seen = views_.pdf_a[k] > 0;
    densities[k] = seen ? views_.pdf_a[k] * (term.light_pdf + term.bsdf * l.pdf_w) : 0.0f;
    value[k] = seen ? views_.value[k] * l.value : 0.0f;
    white[k] = seen ? l.white : 0.0f;
  }
  const float density = sum(densities, lanes_);
  if (!(density > 0)) return;
  const Rgb shared = term.light / density;
  const auto add = [&](Lanes& to, const Lanes& reflectance, float at_y, float amount) {
    for (int k = 0; k < lanes_; ++k) {
      const float here = reflectance[k] + (1 - reflectance[k]) * views_.white[k];
      const float there = at_y + (1 - at_y) * white[k];
      to[k] += value[k] > 0 ? value[k] * here * there * amount : 0.0f;
    }
  };
  add(gathered_.x, first_.reflectance.x, shape.reflectance.x, shared.x);
  add(gathered_.y, first_.reflectance.y, shape.reflectance.y, shared.y);
  add(gathered_.z, first_.reflectance.z, shape.reflectance.z, shared.z);
}

}  // namespace raytracing
