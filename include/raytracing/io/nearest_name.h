#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raytracing {

/// The candidate with the smallest edit distance (insert, erase, replace one byte) to `name`; the
/// first of equals. `candidates` must not be empty.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace raytracing
