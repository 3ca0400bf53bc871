#pragma once

#include <string>
#include <vector>

#include "raytracing/integrator/direct_method.h"

namespace raytracing {

/// The parts of a list between its commas.
std::vector<std::string> split_list(const std::string& text);

/// The value of --methods: names of direct-light methods, each once. Throws UsageError.
std::vector<const DirectMethod*> parse_methods(const std::string& text);

/// The whole table.
std::vector<const DirectMethod*> all_methods();

}  // namespace raytracing
