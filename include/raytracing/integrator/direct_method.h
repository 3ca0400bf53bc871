#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/integrator/visibility.h"
#include "raytracing/sampling/sampler.h"

namespace raytracing {

/// One direction of an estimate of direct light, without what depends on the viewer: the vertex
/// reflects `light` times f cos, times the weight against BSDF sampling where that is wanted.
struct LightSample {
  Vec3 wi;      ///< world, unit
  Rgb light;    ///< Le times visibility over density
  float pdf_w;  ///< density per steradian, that of choosing the light included; 0 = not known
};

/// One question to a direct-light method: how much radiance does `light` send to the viewer of
/// `vertex`, directly?
struct DirectQuery {
  const Vertex& vertex;
  const AreaLight& light;
  float light_pmf;             ///< with which this light was chosen
  Vec2 u;                      ///< the pair of uniform numbers that every method may use
  const PathSampler& sampler;  ///< further numbers: sampler.extra(pair, i)
  std::uint32_t pair;          ///< the number of the pair `u`
  int line_rays;               ///< rays per chord of the methods that count rays, >= 1
  /// Where given and the material is not diffuse, receives the directions that the estimate sums.
  std::vector<LightSample>* directions = nullptr;
};

/// A way to estimate direct light. The seam is the estimate, not a sample with a density: a method
/// may integrate over more than one direction. Every method draws the same one pair of numbers per
/// vertex, and whatever more it needs from the sampler's extra numbers, so that exchanging methods
/// leaves all other dimensions as they were.
struct DirectMethod {
  std::string_view name;
  std::string_view summary;  ///< one line for people, without a full stop
  std::string_view cost;     ///< what one estimate asks of the accelerators
  bool unbiased;
  std::string_view colour;  ///< of its curves in charts, "#rrggbb"
  int mark;                 ///< of its points in charts, a point type of gnuplot

  /// Radiance, in expectation over u; not divided by light_pmf. Where the method has a density and
  /// the material wants it, weighted against BSDF sampling.
  Rgb (*estimate)(const DirectQuery&, Visibility&);

  /// Density per steradian, seen from `from`, with which the method chooses the point `q` of the
  /// light; null for a method without one, whose lights BSDF sampling then never counts.
  float (*pdf_w)(const AreaLight& light, const Vec3& from, const Vec3& q);

  bool asks_segments = false;  ///< whether it needs Scene::occluders() for them

  /// Whether a surface of this material shares its direct light between the method and BSDF
  /// sampling.
  bool uses_mis(const Material& material) const;
};

/// The table of methods, in the order in which they are listed to people.
std::span<const DirectMethod> direct_methods();

/// The method of that name, or null.
const DirectMethod* find_direct_method(std::string_view name);

/// The method of a name that the program itself knows. Throws std::logic_error where the table does
/// not have it.
const DirectMethod& direct_method(std::string_view name);

std::vector<std::string> direct_method_names();

}  // namespace raytracing
