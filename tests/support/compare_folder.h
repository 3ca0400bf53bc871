#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "raytracing/io/image.h"
#include "support/cli_folder.h"

namespace raytracing {

inline ImageData rgb_picture(int width, int height, std::vector<float> values,
                             ImageMetadata metadata = {}) {
  return {width, height, {"R", "G", "B"}, std::move(values), std::move(metadata)};
}

/// Values in [0,1).
inline ImageData random_picture(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  ImageData image = rgb_picture(width, height, {});
  for (int i = 0; i < 3 * width * height; ++i) image.values.push_back(uniform(random));
  return image;
}

/// A folder with pictures to compare.
struct CompareFolder : CliFolder {
  void write(const std::string& name, const ImageData& image) const {
    folder.write(name, encode_image(image, image_ending(name)));
  }
  RunResult compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    return run(arguments);
  }
};

/// With a.exr and b.exr, the same but for one channel: |x-r| = 0.5, at pixel 1,0.
struct OneChannelOff : CompareFolder {
  OneChannelOff() {
    write("a.exr", rgb_picture(2, 1, {1, 1, 1, 1, 1, 0.5f}));
    write("b.exr", rgb_picture(2, 1, {1, 1, 1, 1, 1, 1}));
  }
};

}  // namespace raytracing
