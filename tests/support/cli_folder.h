#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "raytracing/io/file.h"
#include "support/run_program.h"
#include "support/temp_dir.h"

namespace raytracing {

/// The Cornell box, and options that render it in no time.
inline const std::string kCornell = std::string(RAYTRACING_SOURCE_DIR) + "/scenes/cornell.toml";

using Names = std::vector<std::string>;

/// An empty working directory for runs of the program.
class CliFolder {
 public:
  /// Runs the program here.
  RunResult run(std::vector<std::string> arguments) const {
    return run_program_in(folder.path(), std::move(arguments));
  }

  /// Renders the Cornell box, 12 x 8 pixels at 2 spp unless told otherwise, with more options.
  RunResult render(std::vector<std::string> more) const {
    std::vector<std::string> arguments{kCornell};
    for (const char* option : {"--width=12", "--height=8", "--spp=2"}) {
      const std::string name = std::string(option).substr(0, std::string(option).find('='));
      const bool told = std::any_of(more.begin(), more.end(), [&](const std::string& m) {
        return m == name || m.starts_with(name + "=");
      });
      if (!told) arguments.push_back(option);
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /// Writes a scene, s.toml, in which samples are not finite: the radiance of a light is near the
  /// largest float, and overflows when reflected radiance is added to it.
  void write_overflowing_scene() const {
    folder.write("s.toml",
                 "[film]\nwidth = 4\nheight = 4\n[camera]\norigin = [0,0,2]\n"
                 "target = [0,0,0]\n[materials.sun]\ntype = 'diffuse'\nreflectance = 1\n"
                 "emission = 3e38\n[[models]]\nobj = 'm.obj'\nmaterial = 'sun'\n");
    folder.write("m.obj",
                 "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\n"
                 "v -1 1 1\nf 1 2 3 4\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n");
  }

  /// Names of what lies here, hidden files too, sorted.
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
      result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
  }

  std::string bytes(const std::string& name) const { return read_file(folder / name); }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(bytes(name)); }

  TempDir folder;
};

/// The run ended with this code and said this line, and nothing else.
inline void expect_one_line(const RunResult& run, int code, const std::string& line) {
  EXPECT_EQ(run.exit_code, code);
  EXPECT_EQ(run.err, "Raytracing: " + line + "\n");
  EXPECT_EQ(run.out, "");
}

inline std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace raytracing
