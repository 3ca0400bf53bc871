#include "raytracing/study/stress_case.h"

#include <utility>

#include "stress_maker.h"

namespace raytracing {

std::span<const StressCase> stress_cases() {
  static const std::vector<StressCase> all = [] {
    std::vector<StressCase> cases;
    for (auto* make :
         {stress::light_cases, stress::occluder_cases, stress::surface_cases, stress::scene_cases})
      for (StressCase& c : make()) cases.push_back(std::move(c));
    return cases;
  }();
  return all;
}

std::vector<std::string> stress_case_names() {
  std::vector<std::string> names;
  for (const StressCase& c : stress_cases()) names.emplace_back(c.name);
  return names;
}

}  // namespace raytracing
