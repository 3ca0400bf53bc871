#include "result_folder.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <system_error>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"

namespace raytracing {

void ResultFolder::create() const {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw OutputError(path_ + ": " + error.message());
}

void ResultFolder::write(const std::string& name, const std::string& bytes) const {
  OutputFile file(path_ + "/" + name);
  file.write(bytes);
  file.commit();
  print_path(name);
}

void ResultFolder::print_path(const std::string& name) const {
  if (!quiet_) fmt::print("{}/{}\n", path_, name);
}

}  // namespace raytracing
