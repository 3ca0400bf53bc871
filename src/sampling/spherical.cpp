#include "raytracing/sampling/spherical.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "raytracing/math/numeric.h"

namespace raytracing {
namespace {

// The smallest distance of an edge from the point, squared; it prevents 0 / 0 for a point on the
// line of an edge.
constexpr double kMinDistance2 = std::numeric_limits<float>::min();

// The range of solid angles for which float has enough digits to sample. Smaller and larger ones
// are differences of nearly equal angles (2 pi is the solid angle of the whole plane).
constexpr double kFloatLow = 0.01, kFloatHigh = 6;
// The largest ratio, for which float suffices, of the distance beside the rectangle to the height
// above its plane: sampling computes the height from the small difference of a squared cosine
// and 1.
constexpr double kFloatBeside = 16;

// The plane through the point and one edge, given by the angle between its normal and that of the
// rectangle.
struct EdgePlane {
  double cosine, sine;
  // `offset` is the inward distance of the edge from the foot of the point, and `height` is the
  // height of the point.
  EdgePlane(double offset, double height) {
    const double distance = std::sqrt(std::max(height * height + offset * offset, kMinDistance2));
    cosine = offset / distance;
    sine = height / distance;
  }
};

// Returns the angle between neighbouring planes, whose cosine is -a b, as a unit complex number
// (cosine, sine). The sine is computed from the sines without cancellation, which matters for a
// point close to the plane of the rectangle.
DVec2 inner_angle(const EdgePlane& a, const EdgePlane& b) {
  return {-a.cosine * b.cosine, std::sqrt(square(a.sine) + square(a.cosine * b.sine))};
}

double root(double x) { return std::sqrt(std::max(x, 0.0)); }
float root(float x) { return safe_sqrt(x); }

}  // namespace

// This is computed in double: for a point near the plane of the rectangle the solid angle is a
// small difference of angles. Their rounding would be the same for all samples at the point and
// thus bias the estimate.
SphericalRectangle::SphericalRectangle(const Rectangle& rectangle, const Vec3& from)
    : from_(from), x_(rectangle.x), y_(rectangle.y), z_(cross(rectangle.x, rectangle.y)) {
  const DVec3 d = DVec3(rectangle.corner) - DVec3(from);
  x0_ = dot(d, DVec3(x_));
  y0_ = dot(d, DVec3(y_));
  z0_ = dot(d, cross(DVec3(x_), DVec3(y_)));
  if (z0_ > 0) {
    z_ = -z_;
    z0_ = -z0_;
  }
  x1_ = x0_ + static_cast<double>(rectangle.width);
  y1_ = y0_ + static_cast<double>(rectangle.height);

  const EdgePlane n0(-y0_, -z0_), n1(x1_, -z0_), n2(y1_, -z0_), n3(-x0_, -z0_);
  // The inner angles of the spherical rectangle are unit complex numbers; the angle of their
  // product is solid angle + 2 pi. Ureña's k = 2 pi - g2 - g3 is a complex number too.
  const DVec2 g01 = complex_product(inner_angle(n0, n1), inner_angle(n1, n2));
  const DVec2 g23 = complex_product(inner_angle(n2, n3), inner_angle(n3, n0));
  const DVec2 all = complex_product(g01, g23);
  b0_ = n0.cosine;
  b1_ = n2.cosine;
  k_ = {g23.x, -g23.y};
  solid_angle_ = std::atan2(all.y, all.x);
  if (solid_angle_ < 0) solid_angle_ += 2 * std::numbers::pi;
}

bool SphericalRectangle::needs_double() const {
  const double beside2 = square(std::max({0.0, x0_, -x1_})) + square(std::max({0.0, y0_, -y1_}));
  return !(solid_angle_ > kFloatLow && solid_angle_ < kFloatHigh &&
           beside2 < square(kFloatBeside * z0_));
}

template <class Real>
Real SphericalRectangle::sample_x(float u) const {
  const auto real = [](double x) { return static_cast<Real>(x); };
  const Real turn = static_cast<Real>(u) * real(solid_angle_);
  const Real cosine = std::cos(turn), sine = std::sin(turn), b0 = real(b0_);
  const Real kx = real(k_.x), ky = real(k_.y);
  const Real fu = ((kx * cosine - ky * sine) * b0 - real(b1_)) / (kx * sine + ky * cosine);
  const Real cu2 = 1 / (fu * fu + b0 * b0);
  const Real cu = std::copysign(std::sqrt(std::min(cu2, Real(1))), fu);
  return std::clamp(-(cu * real(z0_)) / root(1 - cu2), real(x0_), real(x1_));
}

template <class Real>
Vec3 SphericalRectangle::sample_in(const Vec2& u) const {
  const auto real = [](double x) { return static_cast<Real>(x); };
  const Real x = sample_x<Real>(u.x), y0 = real(y0_), y1 = real(y1_), z0 = real(z0_);
  const Real d2 = x * x + z0 * z0;
  const Real h0 = y0 / std::sqrt(d2 + y0 * y0);
  const Real h1 = y1 / std::sqrt(d2 + y1 * y1);
  const Real h = h0 + static_cast<Real>(u.y) * (h1 - h0);
  const Real y = std::clamp(h * std::sqrt(d2) / root((1 - h) * (1 + h)), y0, y1);
  using Point = glm::vec<3, Real>;
  return Vec3(Point(from_) + x * Point(x_) + y * Point(y_) + z0 * Point(z_));
}

Vec3 SphericalRectangle::sample(const Vec2& u) const {
  return needs_double() ? sample_in<double>(u) : sample_in<float>(u);
}

SphericalRectangle::Strip SphericalRectangle::strip(float u) const {
  const double x = needs_double() ? sample_x<double>(u) : static_cast<double>(sample_x<float>(u));
  const double d2 = x * x + z0_ * z0_;
  return {static_cast<float>(x - x0_), y0_, d2};
}

SphericalTriangle::SphericalTriangle(const std::array<Vec3, 3>& corners, const Vec3& from)
    : from_(from),
      normal_(cross(DVec3(corners[1]) - DVec3(corners[0]), DVec3(corners[2]) - DVec3(corners[0]))),
      height_(dot(DVec3(corners[0]) - DVec3(from), normal_)),
      a_(normalize(DVec3(corners[0]) - DVec3(from))),
      b_(normalize(DVec3(corners[1]) - DVec3(from))),
      c_(normalize(DVec3(corners[2]) - DVec3(from))) {
  const double volume = std::abs(dot(a_, cross(b_, c_)));
  const double denominator = 1 + dot(a_, b_) + dot(b_, c_) + dot(c_, a_);
  solid_angle_ = 2 * std::atan2(volume, denominator);
  const DVec3 n_ab = cross(a_, b_);
  const DVec3 n_ac = cross(a_, c_);
  alpha_ = std::atan2(length(cross(n_ab, n_ac)), dot(n_ab, n_ac));
  cos_c_ = dot(a_, b_);
}

std::optional<Vec3> SphericalTriangle::sample(const Vec2& u) const {
  if (!(solid_angle_ > 0) || height_ == 0) return std::nullopt;
  // The sub-triangle (A, B, C') has the fraction u.x of the area; Arvo's q is the cosine of the arc
  // AC'.
  const double phi = u.x * solid_angle_ - alpha_;
  const double s = std::sin(phi), t = std::cos(phi);
  const double sin_alpha = std::sin(alpha_), cos_alpha = std::cos(alpha_);
  const double p = t - cos_alpha;
  const double r = s + sin_alpha * cos_c_;
  const double denominator = (r * s + p * t) * sin_alpha;
  if (denominator == 0) return std::nullopt;
  const double q = std::clamp(((r * t - p * s) * cos_alpha - r) / denominator, -1.0, 1.0);
  const DVec3 towards_c = c_ - dot(c_, a_) * a_;
  const DVec3 c_prime =
      q * a_ + std::sqrt(std::max(0.0, 1 - q * q)) * (towards_c / length(towards_c));
  // The point on the arc from B to C' is uniform in the cosine of its distance from B.
  const double z = 1 - u.y * (1 - dot(c_prime, b_));
  const DVec3 towards = c_prime - dot(c_prime, b_) * b_;
  const double span = length(towards);
  const DVec3 w =
      span > 0 ? z * b_ + std::sqrt(std::max(0.0, (1 - z) * (1 + z))) * (towards / span) : b_;
  // The intersection is computed in double: a direction at a grazing angle to the plane, rounded to
  // float, would intersect it far away.
  return Vec3(from_ + (height_ / dot(w, normal_)) * w);
}

}  // namespace raytracing
