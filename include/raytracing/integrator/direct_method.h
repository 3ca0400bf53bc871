#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raytracing/integrator/direct_estimate.h"

namespace raytracing {

/// A way to estimate direct light: one row of the table of methods. The seam is the estimate, not a
/// sample with a density: a method may integrate over more than one direction. Every method draws
/// the same one pair of numbers per vertex, and whatever more it needs from the sampler's extra
/// numbers, so that exchanging methods leaves all other dimensions as they were.
struct DirectMethod {
  std::string_view name;
  std::string_view summary;  ///< one line for people, without a full stop
  std::string_view cost;     ///< the queries that one estimate asks
  bool unbiased;
  std::string_view colour;  ///< colour of its curves in charts, "#rrggbb"
  int mark;                 ///< shape of its points in charts, a point type of gnuplot

  /// Adds the light of one estimate, whose expectation is the reflected radiance of query.light.
  void (*estimate)(const DirectQuery& query, RayQueries& rays, DirectEstimate& estimate);

  /// Density per steradian, as seen from the vertex, with which the method chooses the point `q` of
  /// the light: the `pdf_w` that it passes to DirectEstimate. Null for a method without a density,
  /// whose lights BSDF sampling then never counts.
  float (*pdf_w)(const AreaLight& light, const Vertex& from, const Vec3& q) = nullptr;

  /// Whether it asks RayQueries::visible_part(), which throws for a method that does not say so.
  bool asks_segments = false;

  /// Whether a surface of this material shares its direct light between the method and BSDF
  /// sampling.
  bool uses_mis(const Material& material) const { return pdf_w != nullptr && wants_mis(material); }
};

/// The table of methods, in the order in which they are listed to people.
std::span<const DirectMethod> direct_methods();

/// The method of that name, or null.
const DirectMethod* find_direct_method(std::string_view name);

/// The method of a name that the program itself knows. Throws std::logic_error where the table does
/// not have it.
const DirectMethod& direct_method(std::string_view name);

std::vector<std::string> direct_method_names();

/// One whole estimate of the method: the radiance of query.light that the vertex reflects to its
/// viewer, over the probability of the light. `samples`, where given, receives the directions that
/// it sums.
Rgb estimate_direct(const DirectMethod& method, const DirectQuery& query, RayQueries& rays,
                    std::vector<LightSample>* samples = nullptr);

}  // namespace raytracing
