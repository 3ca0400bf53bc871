#include "group_connections.h"

#include <algorithm>
#include <cmath>

#include "raytracing/materials/lobe.h"
#include "raytracing/materials/material.h"
#include "raytracing/math/numeric.h"

namespace raytracing {
namespace {

// A shaft query gives up after this number of steps, and rays are traced instead: what fills a
// shaft that much costs less by rays. The time has a flat minimum, from 16 to 64 in the scenes of
// this repository.
constexpr int kShaftLimit = 32;

// Sum of the first n lanes, in one fixed order.
float sum(const Lanes& lanes, int n) {
  std::array<float, 8> partial{};
  for (int k = 0; k < n; k += 8)
    for (int i = 0; i < 8; ++i) partial[i] += lanes[k + i];
  for (int step = 4; step > 0; step /= 2)
    for (int i = 0; i < step; ++i) partial[i] += partial[i + step];
  return partial[0];
}

}  // namespace

void GroupConnections::begin(std::size_t n) {
  lanes_ = static_cast<int>(n + 7) / 8 * 8;
  all_lambertian_ = true;
  for (int k = 0; k < lanes_; ++k) {
    for (Vec3Lanes* lanes :
         {&first_.origin, &first_.ng, &first_.ns, &first_.wo, &first_.reflectance, &gathered_})
      lanes->set(k, Vec3(0.0f));
    first_.is_ggx[k] = first_.schlick[k] = 0;
    first_.alpha[k] = 1;
  }
}

void GroupConnections::set_first(std::size_t lane, const Vertex& x) {
  const int k = static_cast<int>(lane);
  const LobeShape shape = lobe_shape(*x.material);
  first_.origin.set(k, x.ray_origin());
  first_.ng.set(k, x.ng);
  first_.ns.set(k, x.shading.z);
  first_.wo.set(k, x.shading.to_world(x.wo));
  first_.reflectance.set(k, shape.reflectance);
  first_.is_ggx[k] = shape.is_ggx;
  first_.alpha[k] = shape.alpha;
  first_.schlick[k] = shape.schlick;
  all_lambertian_ = all_lambertian_ && is_lambertian(*x.material);
}

void GroupConnections::connect_to(const Vertex& y, std::size_t owner, RayQueries& rays) {
  const int own = static_cast<int>(owner);
  all_lambertian_ ? evaluate_unoccluded<true>(y) : evaluate_unoccluded<false>(y);
  if (y.normal_replaced)
    for (int k = 0; k < lanes_; ++k)
      if (k != own) connections_.pdf_a[k] = connections_.value[k] = 0;
  remove_occluded(y, own, rays);
}

template <bool kAllLambertian>
void GroupConnections::evaluate_unoccluded(const Vertex& y) {
  const Vec3 position = y.position, ng = y.ng, ns = y.shading.z;
  for (int k = 0; k < lanes_; ++k) {
    const Vec3 d = position - first_.origin.at(k);
    const float distance2 = dot(d, d);
    const Vec3 wi = d / std::sqrt(distance2);
    const float cos_y = -dot(wi, ng);
    const Vec3 nx = first_.ns.at(k);
    const float above =
        std::min(std::min(cos_y, -dot(wi, ns)), std::min(dot(wi, nx), dot(wi, first_.ng.at(k))));
    Lobe l = lambertian_lobe(dot(wi, nx));
    if constexpr (!kAllLambertian) {
      l = lobe(first_.is_ggx[k], first_.alpha[k], first_.schlick[k], nx, first_.wo.at(k), wi);
    }
    const float geometry = above > 0 ? cos_y / distance2 : 0.0f;
    connections_.wo.x[k] = -wi.x;
    connections_.wo.y[k] = -wi.y;
    connections_.wo.z[k] = -wi.z;
    connections_.pdf_a[k] = geometry > 0 ? l.pdf_w * geometry : 0.0f;
    connections_.value[k] = geometry > 0 ? l.value * geometry : 0.0f;
    connections_.schlick[k] = geometry > 0 ? l.schlick : 0.0f;
  }
}

// The owner's bounce has arrived at y, so that its connection is unoccluded.
void GroupConnections::remove_occluded(const Vertex& y, int owner, RayQueries& rays) {
  const Vec3 from = y.ray_origin();
  const Vec3Lanes& to = first_.origin;
  alignas(64) std::array<std::int32_t, kMaxLanes> wanted;
  for (int k = 0; k < lanes_; ++k) wanted[k] = connections_.pdf_a[k] > 0 ? 1 : 0;
  wanted[owner] = 0;
  std::int32_t any = 0;
  for (int k = 0; k < lanes_; ++k) any |= wanted[k];
  if (any == 0) return;
  if (!rays.keep_visible(from, {to.x.data(), to.y.data(), to.z.data(), lanes_}, wanted.data(),
                         kShaftLimit))
    trace_each(from, wanted, rays);
  wanted[owner] = 1;
  for (int k = 0; k < lanes_; ++k) {
    connections_.pdf_a[k] = wanted[k] != 0 ? connections_.pdf_a[k] : 0.0f;
    connections_.value[k] = wanted[k] != 0 ? connections_.value[k] : 0.0f;
  }
}

// Traces a ray for each connection that a shaft query left open.
void GroupConnections::trace_each(const Vec3& from, std::array<std::int32_t, kMaxLanes>& wanted,
                                  RayQueries& rays) const {
  for (int begin = 0; begin < lanes_; begin += 8) {
    unsigned bits = 0;
    for (int i = 0; i < 8; ++i)
      if (wanted[begin + i] != 0) bits |= 1u << i;
    if (bits == 0) continue;
    const unsigned hidden = rays.occluded8(from, &first_.origin.x[begin], &first_.origin.y[begin],
                                           &first_.origin.z[begin], bits);
    for (int i = 0; i < 8; ++i)
      if ((hidden >> i) & 1) wanted[begin + i] = 0;
  }
}

void GroupConnections::add(const Term& term, const Vertex& y) {
  is_lambertian(*y.material) ? add_lambertian(term.light) : add_glossy(term, y);
}

// Light that has overflowed to infinity must not reach lanes that do not see it: 0 times infinity
// is NaN. So a lane without a connection adds 0 whatever the light.
void GroupConnections::add_lambertian(const Rgb& light) {
  const float density = sum(connections_.pdf_a, lanes_);
  if (!(density > 0)) return;
  const Rgb shared = light / density;
  const auto add = [&](Lanes& to, const Lanes& reflectance, float amount) {
    for (int k = 0; k < lanes_; ++k) {
      const float at_x = with_white(reflectance[k], connections_.schlick[k]);
      to[k] += connections_.value[k] > 0 ? connections_.value[k] * at_x * amount : 0.0f;
    }
  };
  add(gathered_.x, first_.reflectance.x, shared.x);
  add(gathered_.y, first_.reflectance.y, shared.y);
  add(gathered_.z, first_.reflectance.z, shared.z);
}

void GroupConnections::add_glossy(const Term& term, const Vertex& y) {
  const LobeShape shape = lobe_shape(*y.material);
  const Vec3 ns = y.shading.z;
  alignas(64) Lanes densities{}, value, schlick;
  for (int k = 0; k < lanes_; ++k) {
    const Lobe l =
        lobe(shape.is_ggx, shape.alpha, shape.schlick, ns, connections_.wo.at(k), term.wi);
    const bool seen = connections_.pdf_a[k] > 0;
    densities[k] = seen ? connections_.pdf_a[k] * (term.light_pdf_w + term.bsdf * l.pdf_w) : 0.0f;
    value[k] = seen ? connections_.value[k] * l.value : 0.0f;
    schlick[k] = seen ? l.schlick : 0.0f;
  }
  const float density = sum(densities, lanes_);
  if (!(density > 0)) return;
  const Rgb shared = term.light / density;
  const auto add = [&](Lanes& to, const Lanes& reflectance, float reflectance_y, float amount) {
    for (int k = 0; k < lanes_; ++k) {
      const float at_x = with_white(reflectance[k], connections_.schlick[k]);
      const float at_y = with_white(reflectance_y, schlick[k]);
      to[k] += value[k] > 0 ? value[k] * at_x * at_y * amount : 0.0f;
    }
  };
  add(gathered_.x, first_.reflectance.x, shape.reflectance.x, shared.x);
  add(gathered_.y, first_.reflectance.y, shape.reflectance.y, shared.y);
  add(gathered_.z, first_.reflectance.z, shape.reflectance.z, shared.z);
}

}  // namespace raytracing
