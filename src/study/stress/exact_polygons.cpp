#include "raytracing/study/stress/exact_polygons.h"

#include <algorithm>
#include <iterator>
#include <utility>

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
  // The slack covers rounding: polygons of one plane may differ across it in the last digit.
  bool meets(const Box& other) const {
    constexpr long double kRounding = 1e-12L;
    const long double slack = kRounding * std::max(size(), other.size());
    for (int i = 0; i < 3; ++i)
      if (low[i] > other.high[i] + slack || high[i] < other.low[i] - slack) return false;
    return true;
  }

 private:
  long double size() const {
    const LVec3 largest = glm::max(glm::abs(low), glm::abs(high));
    return std::max({largest.x, largest.y, largest.z});
  }
};

bool has_area(const LPolygon& polygon) {
  if (polygon.size() < 3) return false;
  const LVec3 twice_area = area_vector(polygon);
  return dot(twice_area, twice_area) > 0;
}

struct Piece {
  LPolygon polygon;
  Box box;
  explicit Piece(LPolygon p) : polygon(std::move(p)), box(polygon) {}
};

// The part of `polygon` outside the window, piece by piece: behind its first edge, behind its
// second but not its first, and so on.
void append_outside(LPolygon polygon, const LPolygon& window, std::vector<Piece>& pieces) {
  for (std::size_t i = 0; i < window.size(); ++i) {
    const LVec3 in = inward(window, i);
    LPolygon outside = clip(polygon, window[i], -in);
    if (has_area(outside)) pieces.emplace_back(std::move(outside));
    polygon = clip(polygon, window[i], in);
    if (!has_area(polygon)) return;
  }
}

// Subtracts the window from the pieces. Pieces that it does not touch keep their places.
void subtract(std::vector<Piece>& pieces, const LPolygon& window) {
  if (!has_area(window)) return;
  const Box box(window);
  std::vector<Piece> rest;
  for (std::size_t i = 0; i < pieces.size();) {
    if (!pieces[i].box.meets(box)) {
      ++i;
      continue;
    }
    append_outside(std::move(pieces[i].polygon), window, rest);
    std::swap(pieces[i], pieces.back());
    pieces.pop_back();
  }
  std::move(rest.begin(), rest.end(), std::back_inserter(pieces));
}

std::vector<LPolygon> polygons_of(std::vector<Piece> pieces) {
  std::vector<LPolygon> polygons;
  for (Piece& piece : pieces) polygons.push_back(std::move(piece.polygon));
  return polygons;
}

// The part of the occluder between p and the plane of the light; only that casts a shadow.
LPolygon between(const LPolygon& occluder, const LVec3& p, const LPolygon& light) {
  const LVec3 n = area_vector(light);
  const LVec3 to_light = dot(light[0] - p, n) > 0 ? n : -n;
  constexpr long double kNearest = 1e-12L;  // share of the way to the light
  return clip(clip(occluder, p + kNearest * (light[0] - p), to_light), light[0], -to_light);
}

}  // namespace

std::vector<LPolygon> difference(const std::vector<LPolygon>& polygons, const LPolygon& window) {
  std::vector<Piece> pieces(polygons.begin(), polygons.end());
  subtract(pieces, window);
  return polygons_of(std::move(pieces));
}

std::vector<LPolygon> visible_pieces(const LPolygon& light, std::span<const LPolygon> occluders,
                                     const LVec3& p) {
  std::vector<Piece> pieces{Piece(light)};
  for (const LPolygon& occluder : occluders) {
    const LPolygon hiding = between(occluder, p, light);
    if (!has_area(hiding)) continue;
    subtract(pieces, shadow(hiding, p, light));
  }
  return polygons_of(std::move(pieces));
}

}  // namespace raytracing
