#pragma once
// What a group of paths does for all of its first vertices at once: their connections to a second
// vertex, and the light that they receive from it. There is one array for each quantity and one
// lane for each first vertex, in loops that the compiler vectorises.

#include <array>

#include "raytracing/integrator/ray_queries.h"

namespace raytracing {

inline constexpr int kMaxLanes = 256;
using Lanes = std::array<float, kMaxLanes>;

struct alignas(64) Vec3Lanes {
  Lanes x, y, z;

  Vec3 at(int k) const { return {x[k], y[k], z[k]}; }
  void set(int k, const Vec3& v) {
    x[k] = v.x;
    y[k] = v.y;
    z[k] = v.z;
  }
};

/// A part of the light that a second vertex y sends to all that see it. To the first vertex x_i it
/// sends f_y(wi) light / sum over k of p_k(y) (light_pdf_w + bsdf p_b(k, wi)); from a Lambertian y,
/// light / sum over k of p_k(y).
struct Term {
  Vec3 wi{0.0f};  ///< where the light comes from, world, unit; unused for a Lambertian y
  Rgb light;
  float light_pdf_w = 1;
  float bsdf = 0;  ///< 1 where BSDF sampling at y may choose wi, else 0
};

/// The first vertices of a group and their connections to one second vertex after the other.
class GroupConnections {
 public:
  /// Begins another group, of at most n <= kMaxLanes first vertices.
  void begin(std::size_t n);
  void set_first(std::size_t k, const Vertex& x);

  /// Connects all first vertices to the second vertex y, at which the bounce of number `owner` has
  /// arrived.
  void connect_to(const Vertex& y, std::size_t owner, RayQueries& rays);
  /// Sends the light of y along the connections.
  void add(const Term& term, const Vertex& y);

  /// The radiance that a first vertex reflects to its viewer of all that has been sent to it.
  Rgb gathered(std::size_t k) const { return gathered_.at(static_cast<int>(k)); }

 private:
  // A lane without a vertex reflects nothing.
  struct FirstVertices {
    Vec3Lanes origin, ng, ns, wo;  // world; `origin` is that of rays
    Vec3Lanes reflectance;
    Lanes is_ggx, alpha, schlick;  // as in LobeShape
  };
  struct alignas(64) Connections {
    Vec3Lanes wo;   // from y to x_k, unit
    Lanes pdf_a;    // p_k(y); 0 where x_k does not see y
    Lanes value;    // f_x G without the reflectance
    Lanes schlick;  // see Lobe
  };

  template <bool kAllLambertian>
  void evaluate_unoccluded(const Vertex& y);
  void remove_occluded(const Vertex& y, int owner, RayQueries& rays);
  void trace_each(const Vec3& from, std::array<std::int32_t, kMaxLanes>& wanted,
                  RayQueries& rays) const;
  void add_lambertian(const Rgb& light);
  void add_glossy(const Term& term, const Vertex& y);

  FirstVertices first_;
  Connections connections_;
  Vec3Lanes gathered_;
  int lanes_ = 0;               // a multiple of 8
  bool all_lambertian_ = true;  // of the first vertices
};

}  // namespace raytracing
