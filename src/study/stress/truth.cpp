#include "raytracing/study/stress/truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <stdexcept>

namespace raytracing {
namespace {

// The BRDF of GGX times the cosine: D of Walter et al. 2007, eq. 33, with the height-correlated
// masking of Heitz 2014, eqs. 72 and 99. All vectors are unit vectors.
double ggx_f_cos(double alpha, const DVec3& n, const DVec3& wo, const DVec3& wi) {
  const double cos_o = dot(n, wo), cos_i = dot(n, wi);
  if (cos_o <= 0 || cos_i <= 0) return 0;
  const DVec3 sum = wo + wi;
  const DVec3 h = normalize(sum);
  const double cos_h = dot(n, h), a2 = alpha * alpha;
  const DVec3 across = cross(n, h);
  const double tan2_h = dot(across, across) / (cos_h * cos_h);
  const double d = a2 / (std::numbers::pi * std::pow(cos_h, 4) * (a2 + tan2_h) * (a2 + tan2_h));
  const auto lambda = [a2](double c) {
    return (std::sqrt(1 + a2 * (1 - c * c) / (c * c)) - 1) / 2;
  };
  return d / (1 + lambda(cos_o) + lambda(cos_i)) / (4 * cos_o);
}

struct Integrand {
  DVec3 p, n, wo, light_normal;
  double alpha;

  double operator()(const DVec3& q) const {
    const DVec3 d = q - p;
    const double r = length(d);
    if (!(r > 0)) return 0;
    return ggx_f_cos(alpha, n, wo, d / r) * std::abs(dot(light_normal, d)) / (r * r * r);
  }
};

// Gauss-Legendre rules on [0,1].
struct Node {
  double x, weight;
};
constexpr std::array kCoarse{
    Node{0.04691007703066800, 0.11846344252809454}, Node{0.23076534494715845, 0.23931433524968324},
    Node{0.5, 0.28444444444444444}, Node{0.76923465505284155, 0.23931433524968324},
    Node{0.95308992296933200, 0.11846344252809454}};
constexpr std::array kFine{
    Node{0.01985507175123188, 0.05061426814518813}, Node{0.10166676129318664, 0.11119051722668724},
    Node{0.23723379504183550, 0.15685332293894364}, Node{0.40828267875217510, 0.18134189168918099},
    Node{0.59171732124782490, 0.18134189168918099}, Node{0.76276620495816450, 0.15685332293894364},
    Node{0.89833323870681336, 0.11119051722668724}, Node{0.98014492824876812, 0.05061426814518813}};

// A part of the triangle (a, b, c) in the coordinates a + s (b - a + t (c - b)), in which the
// corner a is an edge: a peak there is met by cells of its own size.
struct Cell {
  DVec3 a, b, c;
  double s0, s1, t0, t1;
  const Integrand* f;
  double value = 0, error = 0;
  bool along_s = false;  // whether the error comes from the rule in s rather than that in t

  template <class RuleS, class RuleT>
  double apply(const RuleS& rule_s, const RuleT& rule_t) const {
    const double jacobian = length(cross(b - a, c - a)) * (s1 - s0) * (t1 - t0);
    double sum = 0;
    for (const Node& u : rule_s)
      for (const Node& v : rule_t) {
        const double s = s0 + u.x * (s1 - s0), t = t0 + v.x * (t1 - t0);
        sum += u.weight * v.weight * s * (*f)(a + s * (b - a + t * (c - b)));
      }
    return sum * jacobian;
  }
  void evaluate() {
    value = apply(kFine, kFine);
    const double of_s = std::abs(value - apply(kCoarse, kFine));
    const double of_t = std::abs(value - apply(kFine, kCoarse));
    error = of_s + of_t;
    along_s = of_s > of_t;
  }
  bool operator<(const Cell& other) const { return error < other.error; }
};

// The point of a convex polygon that is nearest to the point q of its plane.
LVec3 nearest_point(const LPolygon& polygon, const LVec3& q) {
  bool inside = true;
  LVec3 best = polygon[0];
  long double best2 = dot(q - best, q - best);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (dot(q - polygon[i], inward(polygon, i)) < 0) inside = false;
    const LVec3& a = polygon[i];
    const LVec3 e = polygon[(i + 1) % polygon.size()] - a;
    const long double e2 = dot(e, e);
    if (!(e2 > 0)) continue;
    const LVec3 x = a + std::clamp(dot(q - a, e) / e2, 0.0L, 1.0L) * e;
    if (dot(q - x, q - x) < best2) {
      best = x;
      best2 = dot(q - x, q - x);
    }
  }
  return inside ? q : best;
}

// The polygon's point nearest to where the mirror direction meets its plane, or else its middle.
LVec3 peak(const LPolygon& polygon, const LVec3& p, const LVec3& mirror) {
  const LVec3 n = area_vector(polygon);
  const long double along = dot(mirror, n), height = dot(polygon[0] - p, n);
  if (along * height > 0) return nearest_point(polygon, p + (height / along) * mirror);
  LVec3 middle(0.0L);
  for (const LVec3& corner : polygon) middle += corner / static_cast<long double>(polygon.size());
  return middle;
}

double lambert_radiance(std::span<const LPolygon> pieces, const LVec3& p, const LVec3& n) {
  long double sum = 0;
  for (const LPolygon& piece : pieces) sum += lambert(piece, p, n);
  return static_cast<double>(sum / std::numbers::pi_v<long double>);
}

double area(std::span<const LPolygon> pieces) {
  long double sum = 0;
  for (const LPolygon& piece : pieces) sum += length(area_vector(piece)) / 2;
  return static_cast<double>(sum);
}

struct Seen {
  double radiance = 0;
  double power = 0, whole_power = 0;  // of the visible polygons and of the lights; up to a factor
  double share = 0;                   // of the lights' areas that is seen, their mean

  // The probability under the renderer's choice of lights.
  double visible_share() const {
    return (1 - kEvenLightShare) * power / whole_power + kEvenLightShare * share;
  }
};

// The light that the vertex reflects, with visibility as from the point `eye`.
Seen seen_from(const StressScene& scene, const Vertex& vertex, const LVec3& eye) {
  const LVec3 p(vertex.position);
  const LVec3 ng = normalize(LVec3(vertex.ng)), ns = normalize(LVec3(vertex.shading.z));
  const DVec3 wo = -normalize(DVec3(scene.ray.direction));
  std::vector<LPolygon> occluders;
  for (const std::vector<Vec3>& occluder : scene.occluders)
    occluders.push_back(long_polygon(occluder));
  Seen seen;
  for (const StressScene::Light& light : scene.lights) {
    const LPolygon whole = long_polygon(light.corners);
    seen.whole_power += light.Le * area({&whole, 1});
    const LPolygon above = clip(clip(whole, p, ng), p, ns);
    if (above.size() < 3) continue;
    // Far from the origin of coordinates the shadow rays may begin behind the light.
    const LVec3 n = area_vector(whole);
    if (dot(eye - whole[0], n) * dot(p - whole[0], n) <= 0) continue;
    const std::vector<LPolygon> pieces = visible_pieces(above, occluders, eye);
    seen.power += light.Le * area(pieces);
    seen.share += area(pieces) / area({&whole, 1}) / static_cast<double>(scene.lights.size());
    seen.radiance += light.Le * reflected_radiance(*vertex.material, pieces, p, DVec3(ns), wo);
  }
  return seen;
}

// Half the spacing of floats of the size of the largest coordinate, or a little less.
long double float_rounding(const std::vector<std::vector<Vec3>>& polygons) {
  float largest = 0;
  for (const std::vector<Vec3>& polygon : polygons)
    for (const Vec3& corner : polygon) largest = std::max(largest, max_component(absolute(corner)));
  return 0x1p-24L * static_cast<long double>(largest);
}

}  // namespace

double reflected_radiance(const Material& material, std::span<const LPolygon> pieces,
                          const LVec3& p, const DVec3& n, const DVec3& wo) {
  struct Reflected {
    std::span<const LPolygon> pieces;
    const LVec3& p;
    const DVec3 &n, &wo;
    double operator()(const Diffuse& m) const {
      return double{m.reflectance.x} * lambert_radiance(pieces, p, LVec3(n));
    }
    double operator()(const GgxConductor& m) const {
      return double{m.reflectance.x} * ggx_radiance(pieces, p, n, wo, m.alpha);
    }
  };
  return visit_material(material, Reflected{pieces, p, n, wo});
}

double ggx_radiance(std::span<const LPolygon> pieces, const LVec3& p, const DVec3& n,
                    const DVec3& wo, double alpha) {
  constexpr double kTolerance = 1e-7;
  constexpr int kMostCells = 200000;
  std::vector<Integrand> integrands;
  integrands.reserve(pieces.size());  // the cells point to them
  const LVec3 mirror = 2 * dot(LVec3(n), LVec3(wo)) * LVec3(n) - LVec3(wo);
  std::priority_queue<Cell> cells;
  double sum = 0, error = 0;
  const auto add = [&](Cell cell) {
    cell.evaluate();
    sum += cell.value;
    error += cell.error;
    cells.push(cell);
  };
  for (const LPolygon& whole : pieces) {
    const LPolygon piece = clip(whole, p, LVec3(n));
    if (piece.size() < 3) continue;
    integrands.push_back({DVec3(p), n, wo, DVec3(normalize(area_vector(piece))), alpha});
    const DVec3 apex(peak(piece, p, mirror));
    for (std::size_t i = 0; i < piece.size(); ++i) {
      Cell cell{.a = apex,
                .b = DVec3(piece[i]),
                .c = DVec3(piece[(i + 1) % piece.size()]),
                .s0 = 0,
                .s1 = 1,
                .t0 = 0,
                .t1 = 1,
                .f = &integrands.back()};
      // The first cells go down to the lobe's size, since a lobe between the nodes shows no error.
      for (; cell.s1 > 0.1 * alpha; cell.s1 = cell.s0) {
        cell.s0 = cell.s1 / 8;
        add(cell);
      }
      cell.s0 = 0;
      add(cell);
    }
  }
  for (int split = 0; error > kTolerance * sum && split < kMostCells; ++split) {
    const Cell c = cells.top();
    cells.pop();
    sum -= c.value;
    error -= c.error;
    Cell first = c, second = c;
    if (c.along_s) {
      first.s1 = second.s0 = (c.s0 + c.s1) / 2;
    } else {
      first.t1 = second.t0 = (c.t0 + c.t1) / 2;
    }
    add(first);
    add(second);
  }
  if (error > 1e3 * kTolerance * sum) throw std::runtime_error("cubature does not converge");
  return sum;
}

double integrate_square(const std::function<double(double, double)>& f, int panels) {
  double sum = 0;
  for (int i = 0; i < panels; ++i)
    for (int j = 0; j < panels; ++j)
      for (const Node& u : kFine)
        for (const Node& v : kFine)
          sum += u.weight * v.weight * f((i + u.x) / panels, (j + v.x) / panels);
  return sum / (panels * panels);
}

StressTruth exact_radiance(const StressScene& scene, const Vertex& vertex) {
  if (scene.radiance) return {*scene.radiance, 0, 1};
  const Seen truth = seen_from(scene, vertex, LVec3(vertex.position));
  const LVec3 origin(vertex.ray_origin());
  double rounding = 0;
  const auto look_from = [&](const LVec3& eye) {
    const double seen = seen_from(scene, vertex, eye).radiance;
    rounding = std::max(rounding, std::abs(seen - truth.radiance));
  };
  look_from(origin);
  const long double shift = kOccluderRoundings * float_rounding(scene.occluders);
  for (int axis = 0; axis < 3 && shift > 0; ++axis) {
    LVec3 eye = origin;
    eye[axis] += shift;
    look_from(eye);
  }
  return {truth.radiance, rounding, truth.visible_share()};
}

}  // namespace raytracing
