#include "output_paths.h"

#include <filesystem>
#include <system_error>

#include "raytracing/io/errors.h"

namespace raytracing {

void check_distinct(std::vector<std::string> inputs, const std::vector<std::string>& outputs) {
  std::vector<std::string>& taken = inputs;
  // A path that cannot be followed is told when it is opened.
  const auto place = [](const std::string& path) {
    std::error_code error;
    const auto absolute = std::filesystem::absolute(path, error);
    const auto canonical = std::filesystem::weakly_canonical(absolute, error);
    return (error ? absolute : canonical).string();
  };
  for (const std::string& output : outputs) {
    if (output.empty()) continue;
    for (const std::string& other : taken)
      if (!other.empty() && place(other) == place(output))
        throw UsageError(output + ": would be overwritten: it is named twice");
    taken.push_back(output);
  }
}

}  // namespace raytracing
