#include "raytracing/io/image_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace raytracing {
namespace {

constexpr const char* kModule = "lib/raytracing/openimageio.so";

std::filesystem::path module_path() {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  std::error_code unknown;
  for (const std::filesystem::path& base : {folder, folder.parent_path()})
    if (std::filesystem::exists(base / kModule, unknown)) return base / kModule;
  throw std::runtime_error(fmt::format("the module for images, {}, is neither in {} nor in {}",
                                       kModule, folder.string(), folder.parent_path().string()));
}

// The module stays loaded until the program ends.
const ImageLibrary& load() {
  const std::string path = module_path().string();
  void* module = ::dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (module == nullptr)
    throw std::runtime_error(
        fmt::format("the module for images cannot be loaded: {}", ::dlerror()));
  const auto entry =
      reinterpret_cast<const ImageLibrary* (*)()>(::dlsym(module, "raytracing_image_library"));
  if (entry == nullptr)
    throw std::runtime_error(fmt::format("{} is not the module for images", path));
  return *entry();
}

}  // namespace

const ImageLibrary& image_library() {
  static const ImageLibrary& library = load();
  return library;
}

ImageLibraryPreload::ImageLibraryPreload() {
  module_path();
  // Where no thread is left for it, the library is loaded by its first use.
  loading_ =
      std::async(std::launch::async | std::launch::deferred, [] { image_library(); }).share();
}

void ImageLibraryPreload::check() const {
  if (loading_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) loading_.get();
}

}  // namespace raytracing
