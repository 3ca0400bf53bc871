#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "raytracing/study/chart/run_log.h"
#include "raytracing/study/chart/settings.h"
#include "raytracing/study/metrics/reference.h"

namespace raytracing {

/// The method that renders the reference. For direct light only it is `line`, whose error falls
/// fastest. Otherwise it is `point`: the noise then comes from the bounces, of which it renders the
/// most per second (in the Cornell box its variance times time is two thirds of that of `line`),
/// and it shares no code with the line methods under test.
const DirectMethod& reference_method(const std::optional<std::uint32_t>& max_depth);

/// Renders two halves in turns, with seeds that no run of a chart uses, in chunks of 16, 32, 64 ...
/// samples per pixel until `seconds` have passed, at least one chunk each. The picture has the
/// layers of join_halves(). Empty when stopped.
std::optional<ImageData> render_reference(const Scene& scene, const ChartSettings& settings,
                                          double seconds, const std::atomic<bool>& stop,
                                          const ProgressCallback& progress);

/// Renders and measures the planned runs that are not in the log yet, and adds the picture and the
/// row of each to the log. `progress` counts the samples of these runs. False when stopped;
/// finished runs are kept.
bool make_runs(const Scene& scene, const ChartSettings& settings, const GroundTruth& truth,
               RunLog& log, const std::atomic<bool>& stop, const ProgressCallback& progress);

}  // namespace raytracing
