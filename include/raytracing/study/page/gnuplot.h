#pragma once

#include <string>
#include <vector>

namespace raytracing {

/// The text as a string constant of gnuplot, between single quotes.
std::string gnuplot_string(const std::string& text);

/// A line of a script that sets the variable `name` to an array of these string constants.
std::string gnuplot_array(const std::string& name, const std::vector<std::string>& texts);

/// Runs gnuplot on <folder>/<script>. False when it is not in PATH. Throws OutputError when it
/// fails.
bool run_gnuplot(const std::string& folder, const std::string& script);

}  // namespace raytracing
