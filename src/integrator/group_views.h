#pragma once
// What a group of paths does for all of its first vertices at once: how they see a second vertex,
// and what light they get from it.

#include "raytracing/integrator/visibility.h"
#include "reuse_lanes.h"

namespace raytracing {

/// Light that leaves y for all its viewers: f_y(w) light / sum over k of p_k (light_pdf + bsdf
/// p_b).
struct Term {
  Vec3 wi;
  Rgb light;
  float light_pdf;
  float bsdf;  ///< 1 = the BSDF may choose w, 0 = it may not
};

/// The first vertices of one group after the other, a lane each.
class GroupViews {
 public:
  /// For another group, of at most n <= kMaxLanes first vertices.
  void begin(std::size_t n);
  void set_first(std::size_t k, const Vertex& x);

  /// The first vertices look at the second vertex y. The bounce of number `owner` has arrived
  /// there.
  void look_at(const Vertex& y, std::size_t owner, Visibility& visibility);
  /// The light of a diffuse y to all that see it.
  void add_diffuse(const Rgb& light);
  void add_glossy(const Term& term, const Vertex& y);

  /// What all second vertices have sent to a first one, as radiance to its viewer.
  Rgb gathered(std::size_t k) const { return gathered_.at(static_cast<int>(k)); }

 private:
  // A lane without a vertex reflects nothing.
  struct FirstVertices {
    Vec3Lanes origin, ng, ns, wo;  // world; origin of rays
    Vec3Lanes reflectance;
    Lanes ggx, alpha2, schlick;

    void clear(int k) {
      for (Vec3Lanes* lanes : {&origin, &ng, &ns, &wo, &reflectance}) lanes->set(k, Vec3(0.0f));
      ggx[k] = schlick[k] = 0;
      alpha2[k] = 1;
    }
    void set(int k, const Vertex& v) {
      const LobeShape shape(*v.material);
      origin.set(k, v.ray_origin());
      ng.set(k, v.ng);
      ns.set(k, v.shading.z);
      wo.set(k, v.shading.to_world(v.wo));
      reflectance.set(k, shape.reflectance);
      ggx[k] = shape.ggx;
      alpha2[k] = shape.alpha2;
      schlick[k] = shape.schlick;
    }
  };
  // How the first vertices see one second vertex y.
  struct alignas(64) Views {
    Vec3Lanes wo;  // from y to x_k, unit
    Lanes pdf_a;   // p_k(y); 0 = does not see it
    Lanes value;   // f_x G but for the reflectance
    Lanes white;   // see Lobe
  };

  template <bool kAnyGgx>
  void see(const Vertex& y);
  void hide(const Vertex& y, int owner, Visibility& visibility);
  void ask_each(const Vec3& from, std::array<std::int32_t, kMaxLanes>& wanted,
                Visibility& visibility) const;

  FirstVertices first_;
  Views views_;
  Vec3Lanes gathered_;
  int lanes_ = 0;         // a multiple of 8
  bool any_ggx_ = false;  // among the first vertices
};

}  // namespace raytracing
