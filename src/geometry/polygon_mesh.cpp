#include "raytracing/geometry/polygon_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raytracing {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Returns a * b - c * d with an error of at most 1.5 ulp (Kahan; Jeannerod et al. 2013). The result
// is exactly zero when the products are equal, which it would not be if the compiler fused one of
// the multiplications with the subtraction.
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error;
}

DVec3 exact_cross(const DVec3& a, const DVec3& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

// Returns twice the signed area of the triangle abc, positive when it is counter-clockwise.
double orient(const DVec2& a, const DVec2& b, const DVec2& c) {
  return difference_of_products(b.x - a.x, c.y - a.y, b.y - a.y, c.x - a.x);
}

// Projects the polygon along the axis of the largest component of its normal, with a
// counter-clockwise result. Dropping an axis instead of rotating the plane leaves the other
// coordinates unchanged, so collinear corners stay collinear.
std::vector<DVec2> project(std::span<const Vec3> corners, const DVec3& normal) {
  const DVec3 size = glm::abs(normal);
  const int dropped = size.z >= size.x && size.z >= size.y ? 2 : (size.y >= size.x ? 1 : 0);
  int u = (dropped + 1) % 3;
  int v = (dropped + 2) % 3;
  if (normal[dropped] < 0) std::swap(u, v);
  std::vector<DVec2> points;
  points.reserve(corners.size());
  for (const Vec3& corner : corners) points.emplace_back(corner[u], corner[v]);
  return points;
}

struct Convexity {
  bool convex;
  bool strict;  // convex without collinear or repeated corners
};

// A polygon is convex when every turn goes left and its edges change between leftward and rightward
// exactly twice. More changes mean that it winds around more than once, like a pentagram.
Convexity convexity(const std::vector<DVec2>& points) {
  const std::size_t n = points.size();
  bool strict = true;
  std::vector<DVec2> distinct;
  distinct.reserve(n);
  for (const DVec2& point : points) {
    if (distinct.empty() || point != distinct.back()) distinct.push_back(point);
  }
  while (distinct.size() > 1 && distinct.back() == distinct.front()) distinct.pop_back();
  if (distinct.size() < n) strict = false;
  int changes = 0;
  double last = 0;
  const std::size_t m = distinct.size();
  for (std::size_t i = 0; i < 2 * m; ++i) {  // the first round only sets `last`
    const DVec2& a = distinct[i % m];
    const DVec2& b = distinct[(i + 1) % m];
    const DVec2& c = distinct[(i + 2) % m];
    const double turn = orient(a, b, c);
    if (turn < 0 || (turn == 0 && glm::dot(b - a, c - b) < 0)) return {false, false};
    if (turn == 0) strict = false;
    const double dx = b.x - a.x;
    if (dx == 0) continue;
    if (i >= m && last * dx < 0) ++changes;
    last = dx > 0 ? 1 : -1;
  }
  return {changes <= 2, changes <= 2 && strict};
}

std::vector<Triangle> fan(std::uint32_t n) {
  std::vector<Triangle> triangles;
  triangles.reserve(n - 2);
  for (std::uint32_t i = 1; i + 1 < n; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

// Clips ears from a doubly linked ring of the remaining corners.
class EarClipper {
 public:
  explicit EarClipper(const std::vector<DVec2>& points)
      : points_(points), next_(points.size()), previous_(points.size()), left_(points.size()) {
    const auto n = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      previous_[i] = (i + n - 1) % n;
    }
    reflex_.reserve(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      if (turn(i) <= 0) reflex_.push_back(i);
    }
    suspects_ = reflex_;
    triangles_.reserve(n - 2);
  }

  std::vector<Triangle> run() {
    // A polygon that touches itself may have ears only when touching is allowed. One that crosses
    // itself may have none; then any corner is clipped. A search without result is slow, so the
    // number of such searches is limited.
    int failures_left = 64;
    std::uint32_t at = 0;
    clip_spikes(at);
    while (left_ > 3) {
      std::uint32_t tip = at;
      if (failures_left > 0 && !find(tip, Touching::blocks) && !find(tip, Touching::allowed)) {
        --failures_left;
      }
      at = next_[next_[tip]];  // clipping at the neighbour would make a fan of slivers
      clip(tip);
      clip_spikes(at);
    }
    triangles_.push_back({previous_[at], at, next_[at]});
    return std::move(triangles_);
  }

 private:
  enum class Touching { blocks, allowed };
  static constexpr std::uint32_t kClipped = 0xffffffffu;

  double turn(std::uint32_t i) const {
    return orient(points_[previous_[i]], points_[i], points_[next_[i]]);
  }

  // A spike is a corner where the boundary reverses its direction, or that repeats its neighbour.
  bool is_spike(std::uint32_t i) const {
    const DVec2 in = points_[i] - points_[previous_[i]];
    const DVec2 out = points_[next_[i]] - points_[i];
    return turn(i) == 0 && glm::dot(in, out) <= 0;
  }

  // Returns true when the boundary passes through the tip b a second time, at `twin`, and from
  // there into the ear abc.
  bool enters(std::uint32_t twin, const DVec2& a, const DVec2& b, const DVec2& c) const {
    const auto inside = [&](const DVec2& p) { return orient(a, b, p) > 0 && orient(b, c, p) > 0; };
    return inside(points_[previous_[twin]]) || inside(points_[next_[twin]]);
  }

  bool is_ear(std::uint32_t tip, Touching touching) const {
    const DVec2& a = points_[previous_[tip]];
    const DVec2& b = points_[tip];
    const DVec2& c = points_[next_[tip]];
    if (orient(a, b, c) <= 0) return false;
    const DVec2 low = glm::min(a, glm::min(b, c));
    const DVec2 high = glm::max(a, glm::max(b, c));
    for (const std::uint32_t other : reflex_) {
      const DVec2& p = points_[other];
      if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) continue;
      if (p == b && other != tip && enters(other, a, b, c)) return false;
      if (p == a || p == b || p == c) continue;  // the ear itself, or the other end of a bridge
      const double inside = std::min(orient(a, b, p), std::min(orient(b, c, p), orient(c, a, p)));
      if (inside > 0 || (inside == 0 && touching == Touching::blocks)) return false;
    }
    return true;
  }

  // Advances `tip` to the next ear, or leaves it unchanged and returns false when there is none.
  bool find(std::uint32_t& tip, Touching touching) const {
    std::uint32_t candidate = tip;
    for (std::size_t tries = 0; tries < left_; ++tries, candidate = next_[candidate]) {
      if (!is_ear(candidate, touching)) continue;
      tip = candidate;
      return true;
    }
    return false;
  }

  // Clips spikes first, as triangles of zero area: corners beside a spike may pass for ears
  // although they are not. `at` advances when its own corner is clipped.
  void clip_spikes(std::uint32_t& at) {
    while (!suspects_.empty() && left_ > 3) {
      const std::uint32_t suspect = suspects_.back();
      suspects_.pop_back();
      if (next_[suspect] == kClipped || !is_spike(suspect)) continue;
      if (suspect == at) at = next_[at];
      clip(suspect);
    }
  }

  void clip(std::uint32_t tip) {
    const std::uint32_t before = previous_[tip];
    const std::uint32_t after = next_[tip];
    triangles_.push_back({before, tip, after});
    next_[before] = after;
    previous_[after] = before;
    next_[tip] = kClipped;
    --left_;
    suspects_.insert(suspects_.end(), {before, after});
    // Clipping an ear can only make its neighbours convex. They become reflex only where the
    // polygon is not simple.
    std::erase_if(reflex_, [&](std::uint32_t i) { return i == tip || i == before || i == after; });
    if (turn(before) <= 0) reflex_.push_back(before);
    if (turn(after) <= 0) reflex_.push_back(after);
  }

  const std::vector<DVec2>& points_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<std::uint32_t> reflex_;  // corners that do not turn left; only they may lie in an ear
  std::vector<std::uint32_t> suspects_;  // corners that may be spikes
  std::size_t left_;                     // number of remaining corners
  std::vector<Triangle> triangles_;
};

}  // namespace

void drop_unused_positions(PolygonMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const PolygonMesh::Corner& corner : mesh.corners) used[corner.position] = true;
  if (std::all_of(used.begin(), used.end(), [](bool is_used) { return is_used; })) return;
  std::vector<std::uint32_t> new_index(used.size(), kNone);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    mesh.positions[kept] = mesh.positions[i];
    new_index[i] = kept++;
  }
  mesh.positions.resize(kept);
  for (PolygonMesh::Corner& corner : mesh.corners) corner.position = new_index[corner.position];
}

DVec3 newell_normal(std::span<const Vec3> corners) {
  DVec3 sum(0.0);
  if (corners.size() < 3) return sum;
  const DVec3 origin(corners[0]);
  DVec3 previous = DVec3(corners[1]) - origin;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const DVec3 current = DVec3(corners[i]) - origin;
    sum += exact_cross(previous, current);
    previous = current;
  }
  return sum;
}

bool is_convex(std::span<const Vec3> corners) {
  const DVec3 normal = newell_normal(corners);
  return normal != DVec3(0.0) && convexity(project(corners, normal)).convex;
}

std::vector<Triangle> triangulate(std::span<const Vec3> corners) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  if (n < 3) return {};
  if (n == 3) return {{0, 1, 2}};
  const DVec3 normal = newell_normal(corners);
  if (normal == DVec3(0.0)) return fan(n);  // without area there is no plane to project to
  const std::vector<DVec2> points = project(corners, normal);
  if (convexity(points).strict) return fan(n);
  return EarClipper(points).run();
}

}  // namespace raytracing
