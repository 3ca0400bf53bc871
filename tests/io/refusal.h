#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "raytracing/io/errors.h"
#include "raytracing/io/image.h"

namespace raytracing {

/// The reason why an image is refused, without the name of its file; "read" if it is not.
inline std::string refusal(const std::string& path, const std::string& layer = "") {
  try {
    read_image(path, layer);
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_TRUE(what.starts_with(path + ": ")) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    return what.substr(std::min(what.size(), path.size() + 2));
  }
  return "read";
}

}  // namespace raytracing
