#include "raytracing/study/exact_polygons.h"

#include <algorithm>

namespace raytracing {
namespace {

struct Box {
  LVec3 low, high;

  explicit Box(const LPolygon& polygon) : low(polygon[0]), high(polygon[0]) {
    for (const LVec3& corner : polygon) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  bool meets(const Box& other) const {
    for (int i = 0; i < 3; ++i)
      if (low[i] > other.high[i] || high[i] < other.low[i]) return false;
    return true;
  }
};

bool has_area(const LPolygon& polygon) {
  if (polygon.size() < 3) return false;
  const LVec3 twice_area = area_vector(polygon);
  return dot(twice_area, twice_area) > 0;
}

// The part of `polygon` outside the window, piece by piece: behind its first edge, behind its
// second but not its first, and so on.
void append_outside(LPolygon polygon, const LPolygon& window, std::vector<LPolygon>& pieces) {
  for (std::size_t i = 0; i < window.size(); ++i) {
    const LVec3 in = inward(window, i);
    LPolygon outside = clip(polygon, window[i], -in);
    if (has_area(outside)) pieces.push_back(std::move(outside));
    polygon = clip(polygon, window[i], in);
    if (!has_area(polygon)) return;
  }
}

// Between p, where nothing is thrown a shadow, and the plane of the light.
LPolygon between(const LPolygon& occluder, const LVec3& p, const LPolygon& light) {
  const LVec3 n = area_vector(light);
  const LVec3 to_light = dot(light[0] - p, n) > 0 ? n : -n;
  constexpr long double kNearest = 1e-12L;  // share of the way to the light
  return clip(clip(occluder, p + kNearest * (light[0] - p), to_light), light[0], -to_light);
}

}  // namespace

std::vector<LPolygon> difference(const std::vector<LPolygon>& polygons, const LPolygon& window) {
  std::vector<LPolygon> pieces;
  if (!has_area(window)) return polygons;
  const Box box(window);
  for (const LPolygon& polygon : polygons) {
    if (Box(polygon).meets(box)) {
      append_outside(polygon, window, pieces);
    } else {
      pieces.push_back(polygon);
    }
  }
  return pieces;
}

std::vector<LPolygon> visible_pieces(const LPolygon& light, std::span<const LPolygon> occluders,
                                     const LVec3& p) {
  std::vector<LPolygon> pieces{light};
  const Box whole(light);
  for (const LPolygon& occluder : occluders) {
    const LPolygon hiding = between(occluder, p, light);
    if (!has_area(hiding)) continue;
    const LPolygon dark = shadow(hiding, p, light);
    if (Box(dark).meets(whole)) pieces = difference(pieces, dark);
  }
  return pieces;
}

}  // namespace raytracing
