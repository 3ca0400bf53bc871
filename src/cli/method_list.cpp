#include "method_list.h"

#include <algorithm>

#include "option_list.h"

namespace raytracing {

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::vector<const DirectMethod*> parse_methods(const std::string& text) {
  std::vector<const DirectMethod*> methods;
  for (const std::string& name : split_list(text)) {
    check_name("--methods", name, direct_method_names());
    const DirectMethod* method = find_direct_method(name);
    if (std::find(methods.begin(), methods.end(), method) != methods.end())
      throw_usage("--methods: " + name + " is named twice");
    methods.push_back(method);
  }
  return methods;
}

std::vector<const DirectMethod*> all_methods() {
  std::vector<const DirectMethod*> methods;
  for (const DirectMethod& method : direct_methods()) methods.push_back(&method);
  return methods;
}

}  // namespace raytracing
