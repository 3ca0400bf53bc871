#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace raytracing {

/// Escapes text for HTML, for use between tags and in quoted attributes.
std::string escape_html(std::string_view text);

/// Fills a template written in a subset of Mustache. `{{name}}` is a string, escaped for HTML.
/// `{{#name}}...{{/name}}` is repeated for each element of an array, appears once for any other
/// value, and is left out for null, an empty string or an empty array. Names are looked up in the
/// innermost section first; `{{.}}` is the innermost value itself. `{{! ... }}` is a comment. A
/// section cannot hold another of its own name. Throws std::logic_error for a faulty template: an
/// unknown name, a tag or section without end.
std::string fill_template(std::string_view text, const nlohmann::json& data);

/// Encodes bytes in Base64 with padding, RFC 4648 section 4.
std::string base64(std::string_view bytes);

}  // namespace raytracing
