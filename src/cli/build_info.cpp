#include "build_info.h"

#include <OpenImageIO/oiioversion.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <fstream>
#include <thread>

#include "raytracing/geometry/embree_scene.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"

namespace raytracing {
namespace {

std::string program_version() { return RAYTRACING_VERSION; }

const char* instruction_set() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__AVX__)
  return "AVX";
#elif defined(__SSE4_2__)
  return "SSE4.2";
#elif defined(__SSE2__)
  return "SSE2";
#elif defined(__ARM_NEON)
  return "NEON";
#else
  return "scalar";
#endif
}

// Describes build type, compiler and instruction set on one line.
std::string build_description() {
  return fmt::format("{}, {}, {}, {}", RAYTRACING_BUILD_TYPE,
                     is_optimised() ? "optimised" : "not optimised", "compiler " __VERSION__,
                     instruction_set());
}

// Describes the processor and the number of its threads, as far as the system shows them.
std::string machine_description() {
  std::string processor = "unknown processor";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) {
      processor = line.substr(line.find(": ") + 2);
      break;
    }
  return fmt::format("{}, {} threads", processor, std::thread::hardware_concurrency());
}

}  // namespace

bool is_optimised() {
#if defined(__OPTIMIZE__)
  return true;
#else
  return false;
#endif
}

RunFacts program_facts() {
  RunFacts facts;
  facts.software = "Raytracing " + program_version();
  facts.build = build_description();
  facts.machine = machine_description();
  return facts;
}

std::string program_hash() {
  try {
    return hash_text(hash_bytes(read_file("/proc/self/exe")));
  } catch (const InputError&) {
    return "unknown";
  }
}

std::uint64_t peak_rss_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::uint64_t{1024} * static_cast<std::uint64_t>(usage.ru_maxrss);
}

std::string version_text() {
  return fmt::format(
      "Raytracing {}\n"
      "build: {}\n"
      "instruction set: {}\n"
      "ray queries: {}\n"
      "scenes: TOML, OBJ, MTL\n"
      "images: EXR, PNG, TIFF, JPEG, HDR and others by OpenImageIO {}\n",
      program_version(), build_description(), instruction_set(), embree_version(),
      OIIO_VERSION_STRING);
}

}  // namespace raytracing
