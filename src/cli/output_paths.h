#pragma once

#include <string>
#include <vector>

namespace raytracing {

/// Throws UsageError where one of `outputs` is the same file as one of `inputs` or as another
/// output, by whatever path; empty names are none.
void check_distinct(std::vector<std::string> inputs, const std::vector<std::string>& outputs);

}  // namespace raytracing
