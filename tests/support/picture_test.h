#pragma once
// Renders the scenes of scenes/ and compares them with stored pictures. Only for the tests that
// tests/CMakeLists.txt names as readers of images.

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "raytracing/io/image.h"
#include "raytracing/io/scene_file.h"
#include "raytracing/render/render.h"
#include "support/compare_pictures.h"
#include "support/oiio.h"

namespace raytracing {

inline const std::filesystem::path kSource = RAYTRACING_SOURCE_DIR;

inline SceneDescription load_scene(const std::string& name) {
  LoadReport report;
  return load_scene_file((kSource / "scenes" / (name + ".toml")).string(), direct_method_names(),
                         report)
      .scene;
}

inline NoisyPicture render_picture(SceneDescription description, const RenderOptions& options) {
  const Scene scene(std::move(description), 2);
  const RenderResult result = render(scene, options, false, nullptr);
  EXPECT_EQ(result.non_finite_samples, 0u);
  NoisyPicture picture{options.width, options.height, static_cast<double>(options.spp), {}, {}};
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x) {
      picture.mean.push_back(result.film.at(x, y).mean());
      picture.variance.push_back(result.film.at(x, y).variance_of_mean());
    }
  return picture;
}

/// From an EXR with variance layers and the number of samples in its header.
inline NoisyPicture noisy_picture(const ReadImage& image) {
  NoisyPicture picture{
      image.spec.width, image.spec.height, std::stod(image.attribute("spp")), {}, {}};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto channels = [&](const std::string& prefix) {
        return DVec3(image.at(x, y, prefix + "R"), image.at(x, y, prefix + "G"),
                     image.at(x, y, prefix + "B"));
      };
      picture.mean.push_back(channels(""));
      picture.variance.push_back(channels("variance."));
    }
  return picture;
}

/// Picture, difference and z map for the people who have to find out why. In the PNG of the z map
/// middle grey is 0, and 4 standard deviations end the scale.
inline void write_artefacts(const std::string& name, const NoisyPicture& test,
                            const NoisyPicture& reference, const PictureComparison& comparison) {
  const std::filesystem::path folder = std::filesystem::current_path() / "regression_failures";
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& suffix, const std::vector<DVec3>& pixels) {
    ImageData image{test.width, test.height, {"R", "G", "B"}, {}, {}};
    for (const DVec3& p : pixels)
      for (double c : {p.x, p.y, p.z}) image.values.push_back(static_cast<float>(c));
    const std::filesystem::path path = folder / (name + suffix);
    std::ofstream(path, std::ios::binary) << encode_image(image, image_ending(path.string()));
    std::cerr << "written: " << path.string() << "\n";
  };
  std::vector<DVec3> difference, shown;
  for (std::size_t i = 0; i < test.mean.size(); ++i) {
    difference.push_back(test.mean[i] - reference.mean[i]);
    shown.push_back(0.2 + 0.05 * comparison.z[i]);
  }
  write(".png", test.mean);
  write(".exr", test.mean);
  write("_difference.exr", difference);
  write("_z.exr", comparison.z);
  write("_z.png", shown);
}

}  // namespace raytracing
