#pragma once
// What a rendering asks of Embree, recorded between the library and Embree: the linker sends the
// calls of this program to the recorder (--wrap), so that the library knows nothing of it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raytracing/geometry/embree_api.h"

namespace raytracing {

struct RecordedRay {
  enum class Kind : std::uint32_t {
    closest,
    shadow,
    closest_packet,  ///< the first of 8 that were asked together
    shadow_packet,   ///< the same
    member,          ///< another of them
    absent,          ///< a member that was not asked
  };
  Vec3 origin;
  Kind kind;
  Vec3 direction;
  float far;
};

struct RecordedRays {
  RTCScene scene = nullptr;
  std::vector<RecordedRay> rays;
  std::vector<std::size_t> parts{0};  ///< where to cut them without cutting packets; ends included

  /// Asks Embree again, in the same order, by `threads` threads. Returns the seconds it took.
  double replay(int threads) const;
};

/// Records the queries of one thread from now on, until stop_recording() hands them over.
void start_recording();
RecordedRays stop_recording();

}  // namespace raytracing
