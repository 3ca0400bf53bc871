#pragma once

#include <nlohmann/json_fwd.hpp>

#include "raytracing/render/provenance.h"

namespace raytracing {

/// The known facts as a JSON object, in the order of the list.
nlohmann::ordered_json to_json(const RunFacts& facts);
/// The known facts of one scope.
nlohmann::ordered_json to_json(const RunFacts& facts, FactScope scope);

/// The facts that a JSON object states; other keys are left out.
RunFacts facts_from_json(const nlohmann::ordered_json& object);

}  // namespace raytracing
