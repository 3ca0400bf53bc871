#include "raytracing/integrator/path_log.h"

namespace raytracing {

NonFiniteCause non_finite_cause(const PathLog& log) {
  for (const PathLog::Step& step : log.steps) {
    if (!is_finite(step.position) || !is_finite(step.normal)) return NonFiniteCause::geometry;
    if (!is_finite(step.throughput)) return NonFiniteCause::bsdf;
    if (!is_finite(step.emitted)) return NonFiniteCause::emission;
    if (!is_finite(step.direct)) return NonFiniteCause::direct_light;
  }
  return NonFiniteCause::sum;
}

const char* to_string(NonFiniteCause cause) {
  switch (cause) {
    case NonFiniteCause::geometry:
      return "geometry";
    case NonFiniteCause::bsdf:
      return "bsdf";
    case NonFiniteCause::emission:
      return "emission";
    case NonFiniteCause::direct_light:
      return "direct_light";
    case NonFiniteCause::sum:
      return "sum";
  }
  return "unknown";
}

}  // namespace raytracing
