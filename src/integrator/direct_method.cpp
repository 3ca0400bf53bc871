#include "raytracing/integrator/direct_method.h"

#include <array>
#include <stdexcept>

#include "methods/methods.h"

namespace raytracing {

std::span<const DirectMethod> direct_methods() {
#define METHOD(name) methods::name(),
  static const std::array table{
#include "methods/table.inc"
  };
#undef METHOD
  return table;
}

const DirectMethod* find_direct_method(std::string_view name) {
  for (const DirectMethod& method : direct_methods())
    if (method.name == name) return &method;
  return nullptr;
}

const DirectMethod& direct_method(std::string_view name) {
  if (const DirectMethod* method = find_direct_method(name)) return *method;
  throw std::logic_error("no method is called " + std::string(name));
}

std::vector<std::string> direct_method_names() {
  std::vector<std::string> names;
  for (const DirectMethod& method : direct_methods()) names.emplace_back(method.name);
  return names;
}

Rgb estimate_direct(const DirectMethod& method, const DirectQuery& query, RayQueries& rays,
                    std::vector<LightSample>* samples) {
  DirectEstimate estimate(query, method.uses_mis(*query.vertex.material), rays, samples);
  method.estimate(query, rays, estimate);
  return estimate.radiance();
}

}  // namespace raytracing
