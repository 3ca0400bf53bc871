#pragma once

#include <string>

#include "raytracing/io/image_file.h"
#include "raytracing/io/scene_file.h"
#include "raytracing/render/render.h"

namespace raytracing {

/// All that is told about one finished (or stopped) rendering.
struct RenderRecord {
  const std::string& scene_path;
  const SceneFile& scene;
  const RenderOptions& options;
  const RenderResult& result;
  const std::string& command_line;
  double load_seconds;
  double build_seconds;
};

/// The picture with its header. With `variance`, the layers variance.R/G/B hold the variance of the
/// pixel means.
ImageData to_image(const RenderRecord& record, bool variance);

/// The file that --stats writes: one JSON object.
std::string stats_json(const RenderRecord& record);

}  // namespace raytracing
