#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace raytracing {

/// Text that stands for itself in HTML, between tags and in quoted attributes.
std::string escape_html(std::string_view text);

/// Fills a template written in a small part of Mustache. `{{name}}` is a string, escaped for HTML;
/// `{{#name}}...{{/name}}` stands once for each element of an array, once for another value, and
/// not at all for null, an empty string or an empty array. Names are looked up in the innermost
/// section first; `{{.}}` is the innermost value itself. `{{! ... }}` is a comment. A section may
/// not hold one of its own name. Throws std::logic_error when the template is wrong: a name that is
/// not there, a tag or section without end.
std::string fill_template(std::string_view text, const nlohmann::json& data);

}  // namespace raytracing
